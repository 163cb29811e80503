#include "calib/ingest/pixel_parts.h"

#include <opencv2/imgproc.hpp>

namespace lumi {

cv::Mat grown(const cv::Mat& pixels, int radius_px) {
    cv::Mat larger;
    cv::dilate(pixels, larger,
               cv::getStructuringElement(cv::MORPH_RECT, {2 * radius_px + 1, 2 * radius_px + 1}));
    return larger;
}

PixelParts::PixelParts(const cv::Mat& pixels, int connectivity) {
    cv::Mat centroids;
    count = cv::connectedComponentsWithStats(pixels, part_of, boxes, centroids, connectivity);
}

int PixelParts::area_px(int part) const { return boxes.at<int>(part, cv::CC_STAT_AREA); }

cv::Rect PixelParts::around(int part, int margin_px) const {
    return cv::Rect(boxes.at<int>(part, cv::CC_STAT_LEFT) - margin_px,
                    boxes.at<int>(part, cv::CC_STAT_TOP) - margin_px,
                    boxes.at<int>(part, cv::CC_STAT_WIDTH) + 2 * margin_px,
                    boxes.at<int>(part, cv::CC_STAT_HEIGHT) + 2 * margin_px) &
           cv::Rect({0, 0}, part_of.size());
}

}  // namespace lumi
