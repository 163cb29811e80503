# Writes OUTPUT, which defines lumi::code_version_of, from the contents of the libraries in
# CALIB, MESHING, STAGES and EVALUATE (lists of files). Run as: cmake -DOUTPUT=... -P this file

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
# Packing draws and judges, too: photographs are asked how a package is drawn.
hash_of(evaluate ${EVALUATE})

file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "pipeline/line/code_version.h"

namespace lumi {

std::string code_version_of(const std::string& stage) {
    if (stage == "ingest" || stage == "calibrate" || stage == "poses") return "@calib@";
    if (stage == "mesh" || stage == "depth") return "@meshing@";
    return "@evaluate@";
}

}  // namespace lumi
]])
