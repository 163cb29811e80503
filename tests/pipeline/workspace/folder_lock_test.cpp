#include "pipeline/workspace/folder_lock.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

Error refusal_for(int error_number) {
    try {
        refuse_lock("there", error_number);
    } catch (const Error& error) {
        return error;
    }
}

TEST(FolderLock, AFolderThatIsHeldIsBadInput) {
    const ScratchFolder scratch;
    const FolderLock first(scratch.path());
    try {
        const FolderLock second(scratch.path());
        FAIL() << "the folder was taken twice";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-WORKSPACE-BUSY");
        EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    }
}

TEST(FolderLock, NobodyIsToldOfAnOptionThatTheirCommandMayLack) {
    for (const int reason : {EWOULDBLOCK, ENOLCK})
        EXPECT_EQ(refusal_for(reason).advice().find("--"), std::string::npos) << reason;
}

TEST(FolderLock, AFileSystemThatCannotLockIsNoOtherRun) {
    EXPECT_EQ(refusal_for(EWOULDBLOCK).code(), "E-WORKSPACE-BUSY");
    for (const int reason : {ENOLCK, ENOSYS, EOPNOTSUPP}) {
        EXPECT_EQ(refusal_for(reason).code(), "E-WORKSPACE-LOCK") << reason;
        EXPECT_EQ(refusal_for(reason).kind(), ErrorKind::kBadInput) << reason;
    }
}

}  // namespace
}  // namespace lumi
