#pragma once

#include <string>
#include <vector>

namespace lumi {

/// A text beside a point of a picture, whose axes both go from 0 to 1.
struct PlacedLabel {
    double x = 0.0;
    double y = 0.0;
    std::string text;
};

/// Which labels can be read beside each other: from the lowest point up, each that covers none of
/// those before it. The others are to be looked up in the table that goes with the picture.
[[nodiscard]] std::vector<bool> readable_labels(const std::vector<PlacedLabel>& labels);

}  // namespace lumi
