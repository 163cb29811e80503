#include "calib/work/whole_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::size_t entries_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WholeFolder, AppearsOnlyWhenItIsPutInPlace) {
    const ScratchFolder scratch;
    {
        WholeFolder folder(scratch / "deep/result");
        write_whole_text(folder.staging() / "a.txt", "new");
        EXPECT_FALSE(fs::exists(scratch / "deep/result"));
        folder.put_in_place();
        EXPECT_EQ(read_whole_text(scratch / "deep/result/a.txt"), "new");
    }
    EXPECT_EQ(entries_in(scratch / "deep"), 1U);
}

TEST(WholeFolder, VanishesWhenItIsNotPutInPlace) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "result/a.txt", "old");
    { write_whole_text(WholeFolder(scratch / "result").staging() / "a.txt", "new"); }
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "old");
    EXPECT_EQ(entries_in(scratch.path()), 1U);
}

TEST(WholeFolder, RunsThatAreAliveDoNotDisturbEachOther) {
    const ScratchFolder scratch;
    WholeFolder first(scratch / "result");
    write_whole_text(first.staging() / "a.txt", "first");
    WholeFolder second(scratch / "result");
    write_whole_text(second.staging() / "a.txt", "second");
    second.put_in_place();
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "second");
    first.put_in_place();
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "first");
}

TEST(WholeFolder, CleansUpAfterKilledRunsOfTheSameTargetOnly) {
    const ScratchFolder scratch;
    write_whole_text(scratch / ".result.new-abcdef/a.txt", "remains");
    write_whole_text(scratch / ".other.new-abcdef/a.txt", "another's");
    const WholeFolder folder(scratch / "result");
    EXPECT_FALSE(fs::exists(scratch / ".result.new-abcdef"));
    EXPECT_TRUE(fs::exists(scratch / ".other.new-abcdef"));
}

TEST(WholeFolder, OnlyFoldersOfOurOwnFilesAreReplaced) {
    const ScratchFolder scratch;
    const auto is_frame = [](const std::string& name) { return name.starts_with("frame-"); };
    EXPECT_NO_THROW(expect_only_files_of_ours(scratch / "missing", is_frame));
    fs::create_directory(scratch / "empty");
    EXPECT_NO_THROW(expect_only_files_of_ours(scratch / "empty", is_frame));
    write_whole_text(scratch / "frames/frame-1.png", "ours");
    EXPECT_NO_THROW(expect_only_files_of_ours(scratch / "frames", is_frame));

    write_whole_text(scratch / "photos/IMG_1.jpg", "the user's own");
    write_whole_text(scratch / "nested/frame-1/IMG_1.jpg", "the user's own");
    write_whole_text(scratch / "file", "the user's own");
    for (const char* name : {"photos", "nested", "file"}) {
        try {
            expect_only_files_of_ours(scratch / name, is_frame);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-OUT-EXISTS");
        }
    }
}

TEST(WholeFolder, WhatCannotBePutInPlaceIsRefusedBeforehand) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "file", "no folder");
    EXPECT_NO_THROW(require_writable_whole_folder(scratch / "new/folder/"));
    EXPECT_THROW(require_writable_whole_folder(scratch / "file/folder"), Error);
    EXPECT_FALSE(std::filesystem::exists(scratch / "new"));
}

TEST(WholeFolder, ReplacesInTwoStepsWhereThereIsNoExchange) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "result/a.txt", "old");
    write_whole_text(scratch / "fresh/a.txt", "new");
    replace_folder_in_two_steps(scratch / "fresh", scratch / "result");
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "new");
    EXPECT_EQ(entries_in(scratch.path()), 1U);
}

TEST(WholeFolder, AFailedSecondStepBringsTheOldFolderBack) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "result/a.txt", "old");
    EXPECT_THROW(replace_folder_in_two_steps(scratch / "missing", scratch / "result"), Error);
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "old");
}

TEST(WholeFolder, BringsBackTheFolderOfARunThatDiedBetweenTheSteps) {
    const ScratchFolder scratch;
    write_whole_text(scratch / ".result.old/a.txt", "old");
    const WholeFolder folder(scratch / "result");
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "old");
    EXPECT_FALSE(fs::exists(scratch / ".result.old"));
}

TEST(WholeFolder, TheFolderThatStepsAsideStaysWhereItCannotComeBack) {
    const ScratchFolder scratch;
    write_whole_text(scratch / ".result.old/a.txt", "the only copy");
    // A link that leads nowhere: nothing is there, and no folder can take its place.
    fs::create_symlink("nowhere", scratch / "result");
    clean_up_after_killed_runs(scratch / "result");
    EXPECT_EQ(read_whole_text(scratch / ".result.old/a.txt"), "the only copy");
}

TEST(WholeFolder, MayBeUsedByWhomTheProcessLets) {
    const ScratchFolder scratch;
    const mode_t before = ::umask(027);
    WholeFolder folder(scratch / "result");
    folder.put_in_place();
    ::umask(before);
    EXPECT_EQ(fs::status(scratch / "result").permissions(), fs::perms(0750));
}

TEST(WholeFolder, KeepsFilesOfOthersAndReplacesItsOwn) {
    const ScratchFolder scratch;
    for (const char* name : {"a.txt", "former.txt", "notes.txt", "mine/deep/shot.png"})
        write_whole_text(scratch / "result" / name, name);
    fs::create_symlink("nowhere", scratch / "result" / "link");
    {
        WholeFolder folder(scratch / "result");
        write_whole_text(folder.staging() / "a.txt", "new");
        folder.keep_files_of_others([](const std::string& name) { return name == "former.txt"; });
        folder.put_in_place();
    }
    EXPECT_EQ(read_whole_text(scratch / "result/a.txt"), "new");
    EXPECT_FALSE(fs::exists(scratch / "result/former.txt"));
    EXPECT_EQ(read_whole_text(scratch / "result/notes.txt"), "notes.txt");
    EXPECT_EQ(read_whole_text(scratch / "result/mine/deep/shot.png"), "mine/deep/shot.png");
    EXPECT_EQ(fs::read_symlink(scratch / "result/link"), "nowhere");
    EXPECT_EQ(entries_in(scratch.path()), 1U);
}

TEST(WholeFolder, WhatCannotBeKeptIsNotLost) {
    const auto expect_refused = [](const char* of_others, const char* ours) {
        const ScratchFolder scratch;
        write_whole_text(scratch / "result" / of_others, "the user's own");
        WholeFolder folder(scratch / "result");
        write_whole_text(folder.staging() / ours, "new");
        try {
            folder.keep_files_of_others([](const std::string&) { return false; });
            FAIL() << of_others;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-FILE-WRITE") << of_others;
        }
        EXPECT_EQ(read_whole_text(scratch / "result" / of_others), "the user's own");
    };
    expect_refused("views", "views/1.png");
    expect_refused("views/shot.png", "views");
}

}  // namespace
}  // namespace lumi
