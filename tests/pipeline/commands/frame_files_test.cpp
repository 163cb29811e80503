#include "pipeline/commands/frame_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class FramesOfViews : public testing::Test {
 protected:
    std::vector<fs::path> frames(const std::vector<std::string>& views,
                                 const std::vector<std::string>& held_out = {}) {
        std::vector<std::string> photographs = views;
        photographs.insert(photographs.end(), held_out.begin(), held_out.end());
        return frames_of_views(scratch_.path(), views, kind_, photographs);
    }
    void expect_refused(const std::vector<std::string>& views,
                        const std::vector<std::string>& held_out = {}) {
        try {
            static_cast<void>(frames(views, held_out));
            ADD_FAILURE() << "expected E-OUT-EXISTS";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-OUT-EXISTS");
        }
    }

    ScratchFolder scratch_;
    std::string kind_ = "perpixel";
};

TEST_F(FramesOfViews, AreNamedByViewAndMode) {
    EXPECT_THAT(frames({"a.jpg", "left/a.jpg", "a.perpixel.png"}),
                ElementsAre(scratch_ / "a.perpixel.png", scratch_ / "left_a.perpixel.png",
                            scratch_ / "a_perpixel.perpixel.png"));
}

TEST_F(FramesOfViews, TakeThePlaceOfThoseOfARunBefore) {
    const std::vector<fs::path> first = frames({"a.jpg", "b.jpg"});
    for (const fs::path& frame : first) write_whole_text(frame, "a frame");
    EXPECT_EQ(frames({"a.jpg", "b.jpg"}), first);
}

TEST_F(FramesOfViews, OfOneKindTakeThePlaceOfNoOthers) {
    const std::vector<fs::path> plain = frames({"a.jpg"});
    kind_ = "perpixel.difference";
    EXPECT_THAT(frames({"a.jpg"}), ElementsAre(scratch_ / "a.perpixel.difference.png"));
    kind_ = "perpixel";
    EXPECT_THAT(frames({"a.difference.jpg"}), ElementsAre(scratch_ / "a_difference.perpixel.png"));
}

TEST_F(FramesOfViews, NeverTakeThePlaceOfAPhotograph) {
    EXPECT_NO_THROW(static_cast<void>(frames({"a.jpg"}, {"walk/a.perpixel.png"})));
    write_whole_text(scratch_ / "a.perpixel.png", "the user's own");
    expect_refused({"a.jpg", "a.perpixel.png"});
    expect_refused({"a.jpg"}, {"walk/a.perpixel.png"});
}

TEST_F(FramesOfViews, TakeThePlaceOfNothingButFiles) {
    fs::create_directories(scratch_ / "a.perpixel.png");
    expect_refused({"a.jpg"});
    fs::create_symlink(scratch_ / "elsewhere", scratch_ / "b.perpixel.png");
    expect_refused({"b.jpg"});
}

}  // namespace
}  // namespace lumi
