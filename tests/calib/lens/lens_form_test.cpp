#include "calib/lens/lens_form.h"

#include <gtest/gtest.h>

#include <array>

namespace lumi {
namespace {

constexpr std::array<LensModel, 7> kModels{
    LensModel::kSimplePinhole, LensModel::kPinhole, LensModel::kSimpleRadial,
    LensModel::kRadial,        LensModel::kOpenCv,  LensModel::kFullOpenCv,
    LensModel::kOpenCvFisheye,
};

Camera some_lens(LensModel model) {
    Camera lens{640, 480, model, std::vector<double>(parameter_count(model), 0.0)};
    const std::vector<std::string> names = parameter_names(model);
    for (std::size_t index = 0; index < names.size(); ++index) {
        const std::string& name = names[index];
        lens.parameters[index] = name == "cx"     ? 322.0
                                 : name == "cy"   ? 237.0
                                 : name == "fy"   ? 505.0
                                 : name[0] == 'f' ? 500.0
                                 : name[0] == 'p' ? 0.002
                                                  : -0.03 / static_cast<double>(index);
    }
    return lens;
}

Eigen::Vector2d seen_at(const Camera& lens, double x, double y) {
    return project(lens, {x, y, 1.0}).value();
}

TEST(LensForm, OfTheFocalLengthAloneLeavesThePrincipalPointAndTheDistortion) {
    for (const LensModel model : kModels) {
        const LensForm form = focal_length_alone(model);
        const std::vector<std::string> names = parameter_names(model);
        for (int index = 0; index < static_cast<int>(names.size()); ++index) {
            EXPECT_EQ(is_held(form, index), names[static_cast<std::size_t>(index)][0] != 'f')
                << text_of(form);
        }
    }
}

TEST(LensForm, ANestedModelShowsEveryPointAtTheSamePixel) {
    for (const LensModel simpler : kModels) {
        for (const LensModel richer : kModels) {
            if (!is_nested_in(simpler, richer)) continue;
            const Camera lens = some_lens(simpler);
            const Camera lifted = in_model(lens, richer);
            EXPECT_EQ(lifted.model, richer);
            for (const double x : {-0.5, 0.1, 0.6}) {
                for (const double y : {-0.4, 0.0, 0.3}) {
                    EXPECT_LT((seen_at(lens, x, y) - seen_at(lifted, x, y)).norm(), 1e-10)
                        << name_of(simpler) << " in " << name_of(richer);
                }
            }
        }
    }
}

TEST(LensForm, NestingIsThatOfTheFormulas) {
    const auto nested = [](LensModel a, LensModel b) { return is_nested_in(a, b); };
    EXPECT_TRUE(nested(LensModel::kSimplePinhole, LensModel::kSimpleRadial));
    EXPECT_TRUE(nested(LensModel::kSimplePinhole, LensModel::kPinhole));
    EXPECT_TRUE(nested(LensModel::kPinhole, LensModel::kOpenCv));
    EXPECT_TRUE(nested(LensModel::kRadial, LensModel::kFullOpenCv));
    EXPECT_FALSE(nested(LensModel::kPinhole, LensModel::kSimpleRadial));
    EXPECT_FALSE(nested(LensModel::kPinhole, LensModel::kRadial));
    EXPECT_FALSE(nested(LensModel::kSimpleRadial, LensModel::kPinhole));
    EXPECT_FALSE(nested(LensModel::kOpenCv, LensModel::kRadial));
    for (const LensModel model : kModels) {
        EXPECT_TRUE(nested(model, model));
        if (model == LensModel::kOpenCvFisheye) continue;
        EXPECT_FALSE(nested(model, LensModel::kOpenCvFisheye));
        EXPECT_FALSE(nested(LensModel::kOpenCvFisheye, model));
    }
}

TEST(LensForm, AFisheyeFollowsAWideRectilinearLensToATenthOfAPixel) {
    const Camera lens{1000, 800, LensModel::kRadial, {600, 500, 400, -0.08, 0.01}};
    const Camera fisheye = in_model(lens, LensModel::kOpenCvFisheye);
    for (double x = -0.8; x <= 0.8; x += 0.2) {
        for (double y = -0.6; y <= 0.6; y += 0.2) {
            EXPECT_LT((seen_at(lens, x, y) - seen_at(fisheye, x, y)).norm(), 0.1);
        }
    }
}

TEST(LensForm, LosingTermsKeepsTheOthers) {
    const Camera lens = some_lens(LensModel::kFullOpenCv);
    const Camera simpler = in_model(lens, LensModel::kSimpleRadial);
    EXPECT_EQ(simpler.parameters, (std::vector<double>{502.5, 322, 237, lens.parameters[4]}));
}

TEST(LensForm, AScaledFocalLengthChangesNothingElse) {
    for (const LensModel model : kModels) {
        const Camera lens = some_lens(model);
        const Camera scaled = with_focal_length_scaled(lens, 1.5);
        EXPECT_EQ(focal_length_px(scaled), 1.5 * focal_length_px(lens));
        EXPECT_EQ(principal_point_px(scaled), principal_point_px(lens));
        const Eigen::Vector3d ahead(0.1, -0.05, 1);
        const Eigen::Vector2d from_middle_px = *project(lens, ahead) - principal_point_px(lens);
        EXPECT_LT(
            (*project(scaled, ahead) - principal_point_px(lens) - 1.5 * from_middle_px).norm(),
            1e-9);
    }
}

TEST(LensForm, CountsAndNamesWhatIsFree) {
    for (const LensModel model : kModels) {
        const int count = static_cast<int>(parameter_count(model));
        EXPECT_EQ(parameter_names(model).size(), parameter_count(model));
        EXPECT_EQ(free_parameters(all_free(model)), count);
        EXPECT_EQ(free_parameters(with_principal_point_held(model)), count - 2);
        EXPECT_EQ(free_parameters(all_held(model)), 0);
        for (const int held : with_principal_point_held(model).held) {
            EXPECT_EQ(parameter_names(model)[static_cast<std::size_t>(held)][0], 'c');
        }
    }
    EXPECT_EQ(text_of(all_free(LensModel::kRadial)), "RADIAL");
    EXPECT_EQ(text_of(with_principal_point_held(LensModel::kRadial)), "RADIAL, cx cy held");
    EXPECT_EQ(text_of(all_held(LensModel::kPinhole)), "PINHOLE, all held");
    EXPECT_EQ(parameter_named(LensModel::kOpenCv, "p2"), 7);
    EXPECT_FALSE(parameter_named(LensModel::kOpenCv, "k3").has_value());
}

}  // namespace
}  // namespace lumi
