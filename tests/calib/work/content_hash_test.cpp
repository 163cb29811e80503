#include "calib/work/content_hash.h"

#include <gtest/gtest.h>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

// FIPS 180-4, examples of SHA-256.
constexpr const char* kHashOfNothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kHashOfAbc =
    "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(ContentHash, IsSha256) {
    EXPECT_EQ(sha256_hex(std::string_view("")), kHashOfNothing);
    EXPECT_EQ(sha256_hex(std::string_view("abc")), kHashOfAbc);
    const ScratchFolder scratch;
    write_whole_text(scratch / "abc.txt", "abc");
    EXPECT_EQ(sha256_hex_of_file(scratch / "abc.txt"), kHashOfAbc);
}

}  // namespace
}  // namespace lumi
