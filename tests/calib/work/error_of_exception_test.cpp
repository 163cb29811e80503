#include "calib/work/error_of_exception.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>

namespace lumi {
namespace {

std::filesystem::filesystem_error file_system_error(std::errc reason) {
    return {"cannot look", "there", std::make_error_code(reason)};
}

TEST(ErrorOfException, AnErrorIsItself) {
    const auto error =
        error_of_exception(Error(ErrorKind::kPartialResult, "E-TEST", "half", "do the rest"));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::kPartialResult);
    EXPECT_EQ(error->code(), "E-TEST");
    EXPECT_EQ(error->advice(), "do the rest");
}

TEST(ErrorOfException, TheFileSystemIsBadInputUnlessTheDiskIsFull) {
    const auto looping =
        error_of_exception(file_system_error(std::errc::too_many_symbolic_link_levels));
    ASSERT_TRUE(looping);
    EXPECT_EQ(looping->code(), "E-FILE-SYSTEM");
    EXPECT_EQ(looping->kind(), ErrorKind::kBadInput);
    const auto full = error_of_exception(file_system_error(std::errc::no_space_on_device));
    ASSERT_TRUE(full);
    EXPECT_EQ(full->code(), "E-FILE-SYSTEM");
    EXPECT_EQ(full->kind(), ErrorKind::kResources);
}

TEST(ErrorOfException, MemoryThatRanOutIsResources) {
    const auto error = error_of_exception(std::bad_array_new_length());
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), "E-MEMORY");
    EXPECT_EQ(error->kind(), ErrorKind::kResources);
}

TEST(ErrorOfException, MemoryThatRanOutWithinOpenCvIsResourcesToo) {
    const auto exception_of = [](int code) {
        return cv::Exception(code, "Failed to allocate 75000000 bytes", "OutOfMemoryError",
                             "alloc.cpp", 73);
    };
    const auto error = error_of_exception(exception_of(cv::Error::StsNoMem));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), "E-MEMORY");
    EXPECT_EQ(error->kind(), ErrorKind::kResources);
    EXPECT_FALSE(error_of_exception(exception_of(cv::Error::StsAssert))) << "a bug";
}

TEST(ErrorOfException, ABugIsNone) { EXPECT_FALSE(error_of_exception(std::logic_error("bug"))); }

}  // namespace
}  // namespace lumi
