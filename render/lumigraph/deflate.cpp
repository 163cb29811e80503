#include "render/lumigraph/deflate.h"

#include <zlib.h>

#include <new>

#include "calib/work/error.h"

namespace lumi {

Bytes deflated(const Bytes& bytes) {
    uLongf size = compressBound(bytes.size());
    Bytes result(size);
    if (compress(result.data(), &size, bytes.data(), bytes.size()) != Z_OK) throw std::bad_alloc();
    result.resize(size);
    return result;
}

Bytes inflated(const Bytes& deflated, std::uint64_t size, const std::string& where) {
    // Deflate shortens no more than this: what claims more is refused before memory is taken.
    constexpr std::uint64_t kLargestRatio = 1032;
    const bool may_be = size / kLargestRatio <= deflated.size();
    Bytes result(may_be ? size : 0);
    uLongf found = result.size();
    uLong read = deflated.size();
    // An empty result still needs somewhere to point to.
    Bytef nothing = 0;
    Bytef* into = result.empty() ? &nothing : result.data();
    const bool is_whole = may_be && uncompress2(into, &found, deflated.data(), &read) == Z_OK &&
                          found == size && read == deflated.size();
    if (!is_whole) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-MESH",
                    where + ": does not inflate to " + std::to_string(size) + " bytes",
                    "the package is damaged: copy it again, or build it again with `lumi build`");
    }
    return result;
}

}  // namespace lumi
