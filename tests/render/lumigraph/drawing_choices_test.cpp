#include "render/lumigraph/drawing_choices.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

TEST(DrawingChoices, AllAreVisited) {
    // No more and no fewer members than these.
    const auto& [fades, views, block, tolerance, fills, checks, error, thin] = DrawingChoices{};
    static_cast<void>(fades || views || block > 0 || tolerance > 0 || fills || checks ||
                      error > 0 || thin);
    DrawingChoices all;
    int visited = 0;
    for_each_drawing_choice([&](const auto& choice) {
        auto& member = all.*choice.member;
        const auto usual = DrawingChoices{}.*choice.member;
        EXPECT_EQ(member, usual) << choice.name << " is visited twice";
        member = usual == choice.most ? choice.least : choice.most;
        ++visited;
    });
    EXPECT_EQ(visited, 8);
}

TEST(DrawingChoices, AreWrittenAndReadFromTheLeastToTheMost) {
    const ScratchFolder scratch;
    for_each_drawing_choice([&](const auto& choice) {
        for (const auto value : {choice.least, choice.most}) {
            Lumigraph written = tiny_lumigraph();
            written.drawing.*choice.member = value;
            write_package(scratch / "tiny.lumi", written, tiny_extras());
            EXPECT_EQ(read_package(scratch / "tiny.lumi").drawing, written.drawing) << choice.name;
        }
    });
}

TEST(DrawingChoices, BeyondTheirLimitsAreRefusedByName) {
    for_each_drawing_choice([](const auto& choice) {
        using Value = std::remove_const_t<decltype(choice.least)>;
        if constexpr (!std::is_same_v<Value, bool>) {
            for (const Value value : {choice.least - 1, choice.most + 1}) {
                Lumigraph lumigraph = tiny_lumigraph();
                lumigraph.drawing.*choice.member = value;
                try {
                    validate(lumigraph, "here");
                    ADD_FAILURE() << choice.name << " " << value;
                } catch (const Error& error) {
                    EXPECT_EQ(error.code(), "E-LUMIGRAPH-INVALID");
                    EXPECT_NE(std::string(error.what()).find(choice.name), std::string::npos);
                }
            }
        }
    });
}

}  // namespace
}  // namespace lumi
