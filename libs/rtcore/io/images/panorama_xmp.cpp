#include "rtcore/io/images/panorama_xmp.h"

#include <fmt/format.h>

namespace rtcore {

std::string panoramaXmp(int width, int height) {
    return fmt::format("<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>"
                       "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">"
                       "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
                       "<rdf:Description rdf:about=\"\" "
                       "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" "
                       "GPano:ProjectionType=\"equirectangular\" GPano:UsePanoramaViewer=\"True\" "
                       "GPano:FullPanoWidthPixels=\"{0}\" GPano:FullPanoHeightPixels=\"{1}\" "
                       "GPano:CroppedAreaImageWidthPixels=\"{0}\" GPano:CroppedAreaImageHeightPixels=\"{1}\" "
                       "GPano:CroppedAreaLeftPixels=\"0\" GPano:CroppedAreaTopPixels=\"0\"/>"
                       "</rdf:RDF></x:xmpmeta><?xpacket end=\"r\"?>",
                       width, height);
}

} // namespace rtcore
