#include "calib/work/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lumi {

int resolve_threads(int threads) {
    if (threads > 0) return threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    std::atomic<int> next{0};
    std::exception_ptr first_failure;
    std::mutex failure_mutex;

    const auto work = [&] {
        for (int index = next++; index < count; index = next++) {
            try {
                body(index);
            } catch (...) {
                const std::scoped_lock lock(failure_mutex);
                if (!first_failure) first_failure = std::current_exception();
                next = count;
            }
        }
    };

    const int workers = std::min(resolve_threads(threads), count);
    {
        std::vector<std::jthread> pool;
        for (int worker = 1; worker < workers; ++worker) pool.emplace_back(work);
        work();
    }
    if (first_failure) std::rethrow_exception(first_failure);
}

}  // namespace lumi
