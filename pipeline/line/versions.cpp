#include "pipeline/line/versions.h"

#include <CGAL/version.h>
#include <OpenImageIO/oiioversion.h>
#include <ceres/version.h>

#include <opencv2/core/version.hpp>

#include "pipeline/line/colmap_version.h"

namespace lumi {

std::string version_text() {
    return std::string("lumi ") + LUMI_VERSION + "\n" + colmap_version("colmap") + "\nOpenCV " +
           CV_VERSION + "\nCeres " + CERES_VERSION_STRING + "\nCGAL " + CGAL_VERSION_STR +
           "\nOpenImageIO " + OIIO_VERSION_STRING + "\n";
}

}  // namespace lumi
