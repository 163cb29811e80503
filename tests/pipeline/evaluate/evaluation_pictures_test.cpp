#include "pipeline/evaluate/evaluation_pictures.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Photograph photograph(const std::string& name, int exif_orientation) {
    Photograph photograph;
    photograph.name = name;
    photograph.exif_orientation = exif_orientation;
    return photograph;
}

JudgedView judged(const std::string& name) {
    JudgedView view;
    view.score.name = name;
    view.photograph = ColorImage(60, 40);
    view.photograph(0, 39) = {200, 100, 50};  // Bottom left.
    view.rendering = {view.photograph, GrayImage(60, 40, 255)};
    view.flip = FloatImage(60, 40);
    return view;
}

TEST(EvaluationPictures, OfACameraThatWasHeldUprightStandUpright) {
    const ScratchFolder scratch;
    Capture capture;
    capture.views.resize(2);
    capture.views[0].name = "level.jpg";
    capture.views[1].name = "portrait.jpg";
    const EvaluationPictures pictures(capture,
                                      {photograph("level.jpg", 1), photograph("portrait.jpg", 6)},
                                      RenderMode::kPerPixel);
    for (const View& view : capture.views)
        pictures.write(scratch.path(), RenderMode::kPerPixel, judged(view.name));

    const ColorImage level = panels_of(read_color_image(scratch.path() / "level.png")).photograph;
    EXPECT_EQ(level.width(), 60);
    EXPECT_EQ(level(0, 39).r, 200);
    const ComparisonPanels portrait = panels_of(read_color_image(scratch.path() / "portrait.png"));
    EXPECT_EQ(portrait.photograph.width(), 40);
    EXPECT_EQ(portrait.photograph.height(), 60);
    EXPECT_EQ(portrait.photograph(0, 0).r, 200) << "turned clockwise, bottom left is top left";
    EXPECT_EQ(portrait.rendering(0, 0).r, 200);
    EXPECT_EQ(read_color_image(scratch.path() / "portrait.flip.png").width(), 40);
}

TEST(EvaluationPictures, AreNamedByTheRecordOfTheirEvaluation) {
    const Json evaluation{
        {"mode", "perpixel"},
        {"views", {{{"name", "a.jpg"}, {"picture", "a.png"}, {"flip_picture", "a.flip.png"}}}},
        {"modes", {{"lightfield", 1}}},
        {"rivals", {{"methods", {{"forward warping", 1}}}}}};
    EXPECT_EQ(names_of_pictures(evaluation),
              (std::set<std::string>{"a.png", "a.flip.png", "a.lightfield.png",
                                     "a.forward-warping.png"}));
    for (const char* other :
         {"null", "3", "[]", "{}", R"({"views": 3, "modes": 3, "rivals": null})",
          R"({"views": [3, {"picture": 3}], "rivals": {"methods": []}})"})
        EXPECT_TRUE(names_of_pictures(Json::parse(other)).empty()) << other;
}

}  // namespace
}  // namespace lumi
