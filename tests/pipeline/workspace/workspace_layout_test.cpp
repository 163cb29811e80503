#include <gtest/gtest.h>

#include "pipeline/workspace/workspace.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::string folder_named(const fs::path& folder) {
    return WorkspaceLayout(folder, "cat").folder().string();
}

TEST(WorkspaceLayout, HasANameThatOthersCanBeNamedAfter) {
    EXPECT_EQ(folder_named("wt"), "wt");
    EXPECT_EQ(folder_named("wt/"), "wt");
    EXPECT_EQ(folder_named("a/wt//"), "a/wt");
    EXPECT_EQ(folder_named("../wt/"), "../wt");
    EXPECT_EQ(folder_named("."), fs::current_path().string());
    EXPECT_EQ(folder_named("./"), fs::current_path().string());
    EXPECT_EQ(folder_named(".."), fs::current_path().parent_path().string());
    EXPECT_EQ(WorkspaceLayout("wt/", "cat").package_folder(), "wt/cat.lumi");
}

}  // namespace
}  // namespace lumi
