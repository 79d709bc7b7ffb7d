"""A scene in terms that the Renderer and Cycles share."""
from dataclasses import dataclass, field

from geometry import Soup


@dataclass
class Material:
    """A Lambert surface under a mirror, glass, a pane that only tints, or a rough metal."""
    diffuse: tuple = (0.0, 0.0, 0.0)
    texture: str = ""            # a PNG of three channels; times `diffuse`
    emission: tuple = (0.0, 0.0, 0.0)
    mirror: float = 0.0          # weight of the mirrored ray; the rest is scattered
    glass: float = 0.0           # index of refraction of a closed solid, or 0
    pane: tuple = ()             # what goes straight through, unbent and unmirrored
    absorbs: tuple = ()          # extinction inside of that solid, per unit
    metal: tuple = ()            # colour of a GGX metal of `roughness`
    roughness: float = 0.0       # of metal, and of glass


@dataclass
class Light:
    """In the units of docs/shading.md: W/sr, W/m2 of directional ones."""
    kind: str                    # point, directional, sphere, rectangle
    intensity: tuple
    position: tuple = (0.0, 0.0, 0.0)
    direction: tuple = (0.0, -1.0, 0.0)
    right: tuple = (1.0, 0.0, 0.0)
    radius: float = 0.0
    size: tuple = (1.0, 1.0)


@dataclass
class Scene:
    eye: tuple
    look_at: tuple
    fov: float                   # between left and right, degrees
    bounces: int = 16
    caustics: bool = False
    background: tuple = (0.0, 0.0, 0.0)
    sky: object = None           # array of height x width x 3: radiance, from straight up to straight down, -z in the middle
    materials: list = field(default_factory=list)
    lights: list = field(default_factory=list)
    soup: Soup = field(default_factory=Soup)

    def material(self, *values, **named):
        """Adds one and returns its number."""
        self.materials.append(Material(*values, **named))
        return len(self.materials) - 1
