#include "calib/poses/firm_joints.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "tests/calib/poses/matched_job.h"

namespace lumi {
namespace {

class FirmJoints : public MatchedJob {
 protected:
    FirmJoints() {
        match(synthetic_capture(pinhole_camera(1000, 800, 900), {.views = 4, .noise_px = 0.3}));
    }
};

TEST_F(FirmJoints, LeaveACaptureThatHangsTogetherAsItIs) {
    const JointCheck check = with_firm_joints(job(), scene_.truth);
    EXPECT_EQ(check.trouble, "");
    EXPECT_EQ(check.mapped.views.size(), 4u);
    EXPECT_LT(relative_position_error(check.mapped, scene_.truth), 1e-12);
    EXPECT_TRUE(evidence_.warnings.empty());
}

TEST_F(FirmJoints, AreNotAskedAboutAnyLongerOnRequest) {
    progress_.interrupt();
    EXPECT_THROW(static_cast<void>(with_firm_joints(job(), scene_.truth)), Error);
}

}  // namespace
}  // namespace lumi
