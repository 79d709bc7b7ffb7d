/// Which of a file's two bodies a request takes, and whether it has it already. Pure; nothing throws.
#pragma once

#include <string_view>

namespace bridge {

/// Whether a header Accept-Encoding allows gzip; false without one, or where gzip has the weight 0.
bool takesGzip(std::string_view acceptEncoding);

/// Whether a header If-None-Match names that entity tag: `*`, or a list; weak ones count (RFC 9110, 13.1.2).
bool namesTag(std::string_view ifNoneMatch, std::string_view tag);

} // namespace bridge
