#include "calib/work/content_hash.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "calib/work/process_memory.h"
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

TEST(ContentHash, AFileIsReadInBlocksToItsEnd) {
    const ScratchFolder scratch;
    // FIPS 180-4: a million times "a"; and more than one block, which ends in the middle of one.
    write_whole_text(scratch / "a.txt", std::string(1000000, 'a'));
    EXPECT_EQ(sha256_hex_of_file(scratch / "a.txt"),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    const std::string text = std::string(std::size_t{2} << 20, 'x') + "end";
    write_whole_text(scratch / "x.txt", text);
    EXPECT_EQ(sha256_hex_of_file(scratch / "x.txt"), sha256_hex(text));
    write_whole_text(scratch / "none.txt", "");
    EXPECT_EQ(sha256_hex_of_file(scratch / "none.txt"), kHashOfNothing);
}

TEST(ContentHash, TakesNoMoreMemoryForALargerFile) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "large", "");
    std::filesystem::resize_file(scratch / "large", std::size_t{200} << 20);
    if (!forget_peak_memory()) GTEST_SKIP() << "the peak of memory cannot be told here";
    const std::uint64_t before = peak_memory().value();
    static_cast<void>(sha256_hex_of_file(scratch / "large"));
    EXPECT_LT(peak_memory().value(), before + (std::uint64_t{50} << 20));
}

TEST(ContentHash, WhatIsNoFileIsRefusedByItsName) {
    const ScratchFolder scratch;
    for (const auto& path : {scratch.path(), scratch / "none"}) {
        try {
            static_cast<void>(sha256_hex_of_file(path));
            FAIL() << path;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-FILE-READ");
            EXPECT_EQ(std::string(error.what()).find(path.string()), 0U);
        }
    }
}

}  // namespace
}  // namespace lumi
