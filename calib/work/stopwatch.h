#pragma once

namespace lumi {

/// What a piece of work cost.
struct Cost {
    double wall_s = 0.0;
    double cpu_s = 0.0;     ///< User and system time of this process and of its finished children.
    double peak_mib = 0.0;  ///< Largest resident set of this process or of a child, so far.
};

/// Measures from its construction on.
class Stopwatch {
 public:
    Stopwatch();
    [[nodiscard]] Cost elapsed() const;

 private:
    double wall_start_s_;
    double cpu_start_s_;
};

}  // namespace lumi
