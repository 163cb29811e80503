# Writes OUTPUT, which defines lumi::code_version_of, from the contents of the libraries in
# CALIB, MESHING, LUMIGRAPH, STAGES and EVALUATE (lists of files). Run as: cmake -DOUTPUT=... -P this file

function(hash_of result)
  set(text "")
  foreach(library IN LISTS ARGN)
    file(SHA256 ${library} hash)
    string(APPEND text ${hash})
  endforeach()
  string(SHA256 hash "${text}")
  set(${result} ${hash} PARENT_SCOPE)
endfunction()

hash_of(calib ${CALIB} ${STAGES})
hash_of(meshing ${MESHING} ${STAGES})
# Packing chooses views, compares exposures, and draws to see how many views to ask for depth.
hash_of(pack ${MESHING} ${LUMIGRAPH} ${STAGES} ${EVALUATE})
hash_of(evaluate ${EVALUATE})

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "pipeline/line/code_version.h"

namespace lumi {

std::string code_version_of(const std::string& stage) {
    if (stage == "ingest" || stage == "calibrate" || stage == "poses") return "@calib@";
    if (stage == "mesh" || stage == "depth") return "@meshing@";
    if (stage == "evaluate") return "@evaluate@";
    return "@pack@";
}

}  // namespace lumi
]])
