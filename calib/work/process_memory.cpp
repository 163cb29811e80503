#include "calib/work/process_memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace lumi {
namespace {

constexpr const char* kStatus = "/proc/self/status";

/// The number after `key` in a file of lines "Key:   number kB", in bytes.
std::optional<std::uint64_t> bytes_after(const std::string& key, const char* path) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        if (!line.starts_with(key)) continue;
        return std::stoull(line.substr(key.size())) * 1024;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> memory_in_use() { return bytes_after("VmRSS:", kStatus); }

std::optional<std::uint64_t> peak_memory() { return bytes_after("VmHWM:", kStatus); }

std::optional<std::uint64_t> memory_available() {
    return bytes_after("MemAvailable:", "/proc/meminfo");
}

int pieces_within(double budget, double kept, double per_piece, int most) {
    if (per_piece <= 0) return most;
    return static_cast<int>(std::clamp((budget - kept) / per_piece, 1.0, 1.0 * most));
}

void release_free_memory() { malloc_trim(0); }

void keep_little_free_memory() {
    constexpr int kKept = 8 << 20;
    mallopt(M_MMAP_THRESHOLD, kKept);
    mallopt(M_TRIM_THRESHOLD, kKept);
}

void keep_free_memory() {
    constexpr int kKept = 256 << 20;
    constexpr int kTakenAtOnce = 32 << 20;
    mallopt(M_MMAP_THRESHOLD, kTakenAtOnce);
    mallopt(M_TRIM_THRESHOLD, kKept);
    mallopt(M_TOP_PAD, kTakenAtOnce);
}

bool forget_peak_memory() {
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;  // proc(5): resets VmHWM.
    return file.good();
}

}  // namespace lumi
