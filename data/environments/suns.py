"""Where the suns of the drawn skies stand: skies and scenes share these numbers."""
import math


def towards(azimuth, elevation):
    """Unit vector; azimuth in degrees from -z towards +x, elevation above the horizon."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return (math.cos(e) * math.sin(a), math.sin(e), -math.cos(e) * math.cos(a))


SUNSET = towards(-38.0, 7.0)
DAY = towards(112.0, 54.0)
