#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumi {

/// Tests that lie elsewhere than what they are of, in words:
/// "tests/meshing/depth/disparity_test.cpp: belongs to tests/meshing/warp". The test of a header or
/// source X is named X_test.cpp and lies below tests/ as X lies in its room; tests of several
/// things have names of their own.
[[nodiscard]] std::vector<std::string> misplaced_tests(const std::filesystem::path& repository);

}  // namespace lumi
