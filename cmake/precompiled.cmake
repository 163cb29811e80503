# The headers that nearly every file reads are parsed three times in all, not six hundred times: a third of the build's time.
# Each file still names what it uses; the sanitizers' build goes without and finds what is missing.

set(LUMI_PRECOMPILED_HEADERS
  <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numeric> <optional>
  <random> <set> <span> <string> <string_view> <unordered_map> <vector> <Eigen/Dense>)
set(LUMI_PRECOMPILED_HEADERS_OF_COMMANDS ${LUMI_PRECOMPILED_HEADERS} <CLI/CLI.hpp> <nlohmann/json.hpp>)
set(LUMI_PRECOMPILED_HEADERS_OF_TESTS
  ${LUMI_PRECOMPILED_HEADERS} <fstream> <sstream> <gmock/gmock.h> <gtest/gtest.h> <nlohmann/json.hpp>)

# lumi_precompile(NAME HEADERS LIBRARY...): a target that others take their precompiled headers from.
function(lumi_precompile name headers)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE Eigen3::Eigen lumi_warnings ${ARGN})
  target_precompile_headers(${name} PRIVATE ${headers})
endfunction()

# Every target of TYPE in FOLDER takes its precompiled headers from NAME.
function(lumi_take_precompiled folder type name)
  lumi_targets_in(targets ${folder} ${type})
  foreach(target IN LISTS targets)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endforeach()
endfunction()
