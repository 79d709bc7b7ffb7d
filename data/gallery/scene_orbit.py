"""A girl in a red dress, afloat high above the Earth (figure 8.9); the stars are the environment `space`."""
import girl
import palette
import space
from pose import tilted


def build(model):
    model.material("body", (1, 1, 1), roughness=0.6)
    model.material("hair", (1, 1, 1), roughness=0.5)
    model.material("dress", (0.5, 0.007, 0.012), roughness=0.6, double_sided=True)
    model.material("earth", (1, 1, 1), roughness=1.0, texture=model.texture(space.earth_map()))
    model.material("air", (1, 1, 1), roughness=1.0, texture=model.texture(space.glow_mask()), mode="BLEND",
                   double_sided=True)
    palette.use(model, "cheek", "eye")
    for mesh, material in girl.build():
        mesh = tilted(mesh.moved(0.0, -1.0, 0.0), "z", -24)
        model.add(mesh.turned(-28), material)
    model.add(space.earth(), "earth")
    model.add(space.glow((0.0, 2.2, 4.0)), "air")
    space.add_stars(model)
