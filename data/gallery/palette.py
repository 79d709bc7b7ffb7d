"""Materials that the scenes of the gallery share, by name."""
MATERIALS = {
    "hide": dict(colour=(1, 1, 1), roughness=0.75), "horn": dict(colour=(0.55, 0.47, 0.34), roughness=0.3),
    "eye": dict(colour=(0.015, 0.01, 0.009), roughness=0.05), "fur": dict(colour=(1, 1, 1), roughness=0.9),
    "shell": dict(colour=(0.012, 0.011, 0.011), roughness=0.1),
    "cheek": dict(colour=(0.85, 0.82, 0.72), roughness=0.2),
    "skin": dict(colour=(1, 1, 1), roughness=0.7), "ivory": dict(colour=(0.72, 0.62, 0.45), roughness=0.25),
    "lacquer": dict(colour=(0.3, 0.016, 0.014), roughness=0.08),
    "gold": dict(colour=(1.0, 0.72, 0.32), metallic=1.0, roughness=0.03),
    "gilt": dict(colour=(0.75, 0.5, 0.18), metallic=0.6, roughness=0.25),
    "chrome": dict(colour=(0.9, 0.91, 0.93), metallic=1.0, roughness=0.0),
    "mirror": dict(colour=(0.94, 0.96, 0.95), metallic=1.0, roughness=0.0),
    "leather": dict(colour=(0.022, 0.019, 0.018), roughness=0.25),
    "wood": dict(colour=(0.36, 0.19, 0.09), roughness=0.3),
    "porcelain": dict(colour=(0.82, 0.81, 0.78), roughness=0.06),
    "orange": dict(colour=(0.85, 0.3, 0.02), roughness=0.35),
    "apple": dict(colour=(0.6, 0.035, 0.02), roughness=0.15),
    "lime": dict(colour=(0.3, 0.5, 0.05), roughness=0.3), "coloured": dict(colour=(1, 1, 1), roughness=0.16),
}


def use(model, *names):
    """Defines these materials in the model."""
    for name in names:
        model.material(name, **MATERIALS[name])


def add(model, parts):
    for mesh, material in parts:
        model.add(mesh, material)
