#include "pipeline/commands/psnr_text.h"

#include "pipeline/text/number_text.h"

namespace lumi {

std::string psnr_text(double whole_db, std::optional<double> covered_db, double coverage) {
    std::string text = number_text(whole_db, 2) + " dB";
    if (covered_db)
        text += ", " + number_text(*covered_db, 2) + " dB where it is covered (" +
                number_text(100 * coverage, 1) + " %)";
    return text;
}

}  // namespace lumi
