#include "pipeline/evaluate/stale_package.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/whole_file.h"
#include "pipeline/report/standing_package.h"
#include "pipeline/workspace/content.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::IsEmpty;

/// A workspace as a build leaves it, as far as telling what its package was made from goes.
class StalePackage : public testing::Test {
 protected:
    StalePackage() {
        write_whole_text(layout_.package_folder() / "lumigraph.json", "{}");
        for (const char* file : {"ingest/000001.png", "poses/pinhole/cameras.txt",
                                 "mesh/camera_mesh.ply", "depth/a.tif", "depth/done.json"})
            write_whole_text(layout_.folder() / file, file);
        record_.package_sha256 = sha256_hex(std::string_view("{}"));
        record_.pictures_sha256 = sha256_of({"ingest/000001.png", "poses/pinhole/cameras.txt"});
        record_.mesh_sha256 = sha256_of({"mesh/camera_mesh.ply"});
        record_.depth_sha256 = sha256_of({"depth/a.tif"});
        record_.configuration_sha256 = "this configuration";
        last_run("this configuration", {"ingest", "poses", "mesh", "depth", "pack"});
    }

    /// Of files that hold their names.
    static std::string sha256_of(const std::vector<std::string>& files) {
        std::vector<ContentEntry> entries;
        for (const std::string& file : files) entries.push_back({file, sha256_hex(file)});
        return sha256_of_content(entries);
    }
    void last_run(const std::string& configuration, const std::vector<std::string>& stages,
                  const Json& failure = nullptr) const {
        Json run{{"configuration_sha256", configuration}, {"stages", Json::array()}};
        for (const std::string& stage : stages)
            run["stages"].push_back({{"name", stage}, {"evidence", Json::object()}});
        if (!failure.is_null()) run["failure"] = failure;
        write_json_file(layout_.stages_path(), run);
    }
    [[nodiscard]] std::string reason() const { return why_package_is_stale(layout_, record_, 1); }

    ScratchFolder scratch_;
    WorkspaceLayout layout_{scratch_ / "work", "box"};
    PackRecord record_;
};

TEST_F(StalePackage, IsNoneWhereAllIsAsItWasPacked) {
    EXPECT_THAT(reason(), IsEmpty());
    std::filesystem::remove(layout_.stages_path());
    EXPECT_THAT(reason(), IsEmpty());
}

TEST_F(StalePackage, IsToldByEverythingThatItWasMadeFrom) {
    for (const char* file : {"ingest/000001.png", "poses/pinhole/cameras.txt",
                             "mesh/camera_mesh.ply", "depth/a.tif", "box.lumi/lumigraph.json"}) {
        const std::string before = read_whole_text(layout_.folder() / file);
        write_whole_text(layout_.folder() / file, "other");
        EXPECT_THAT(reason(), HasSubstr("the package")) << file;
        write_whole_text(layout_.folder() / file, before);
    }
    EXPECT_THAT(reason(), IsEmpty());
}

TEST_F(StalePackage, WhatSomebodyPutBesideTheOutputsOfAStageDoesNotCount) {
    const ContentEntry output{"depth/a.tif", sha256_hex(std::string_view("depth/a.tif"))};
    write_done_marker(layout_.folder() / "depth/done.json",
                      {{"depth", "", "", "", ""}, {output}, {}, {}});
    EXPECT_THAT(reason(), IsEmpty());
    write_whole_text(layout_.folder() / "depth/Thumbs.db", "made by a file manager");
    EXPECT_THAT(reason(), IsEmpty());
    write_whole_text(layout_.folder() / "depth/a.tif", "other");
    EXPECT_THAT(reason(), HasSubstr("the package"));
}

TEST_F(StalePackage, IsToldByARunThatFailed) {
    last_run("this configuration", {"ingest"}, {{"stage", "depth"}, {"code", "E-DEPTH-MEMORY"}});
    EXPECT_THAT(reason(), HasSubstr("depth (E-DEPTH-MEMORY)"));
}

TEST_F(StalePackage, IsToldByARunOfAnotherConfigurationThatDidNotComeToThePackage) {
    last_run("this configuration", {"ingest", "poses"});
    EXPECT_THAT(reason(), IsEmpty());
    last_run("another configuration", {"ingest", "poses"});
    EXPECT_THAT(reason(), HasSubstr("earlier configuration"));
    // What another configuration leaves as it was need not be packed again.
    last_run("another configuration", {"ingest", "poses", "mesh", "depth", "pack"});
    EXPECT_THAT(reason(), IsEmpty());
}

TEST_F(StalePackage, RecordsOfEarlyVersionsTellAsMuchAsTheyHold) {
    record_.mesh_sha256.clear();
    record_.depth_sha256.clear();
    record_.configuration_sha256.clear();
    last_run("another configuration", {"ingest", "poses"});
    write_whole_text(layout_.folder() / "depth" / "a.tif", "other");
    EXPECT_THAT(reason(), IsEmpty());
}

TEST_F(StalePackage, StandsThereAsAFormerOne) {
    const auto standing = [&] {
        return standing_package(layout_, read_json_file(layout_.stages_path()));
    };
    EXPECT_FALSE(standing().exists);
    write_json_file(layout_.stage_folder("pack") / "pack.json",
                    Json{{"held_out", Json::array()},
                         {"pictures_sha256", record_.pictures_sha256},
                         {"package_sha256", record_.package_sha256}});
    EXPECT_TRUE(standing().exists);
    EXPECT_FALSE(standing().is_former());
    last_run("", {"ingest"}, {{"stage", "poses"}, {"code", "E-POSES-FEW"}});
    EXPECT_TRUE(standing().is_former());
    write_whole_text(layout_.stage_folder("pack") / "pack.json", "damaged");
    EXPECT_TRUE(standing().is_former());
}

}  // namespace
}  // namespace lumi
