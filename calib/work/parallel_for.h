#pragma once

#include <cstddef>
#include <functional>

namespace lumi {

/// Calls `body(0) ... body(count - 1)`, each once, on at most `threads` threads (0: all cores).
///
/// Each index must write only what belongs to it, so that the result is the same for any number of
/// threads. The first exception thrown by a body ends the remaining work and is rethrown here. A
/// body may call it again.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

/// The same for work so short that an index alone is not worth handing out: calls
/// `body(first, end)` for runs of `run` indices of `count`, the last one shorter.
void parallel_for_runs(std::size_t count, std::size_t run, int threads,
                       const std::function<void(std::size_t first, std::size_t end)>& body);

/// The number of threads that `threads` stands for: itself, or all cores when it is 0.
[[nodiscard]] int resolve_threads(int threads);

}  // namespace lumi
