"""What may be added to a block, by its keyword, and to the end of a scene."""

PATTERNS = ("agate bozo boxed bumps cells crackle cylindrical dents granite leopard marble onion planar quilted radial ripples spherical "
            "spotted waves wood wrinkles").split()
SOLIDS = ("union merge intersection difference sphere box cylinder cone torus plane blob height_field lathe sor prism superellipsoid text mesh "
          "mesh2 bicubic_patch quadric quartic cubic poly isosurface julia_fractal parametric sphere_sweep disc polygon triangle "
          "smooth_triangle object").split()


def axis(rng):
    return rng.pick("x", "y", "z")


def scaling(rng):
    return f"scale {rng.pick('0.3', '2', '<1, 2, 1>', '<0.5, 1, 1.5>', '<-1, 1, 1>')}"


def move(rng):
    return rng.made(lambda: scaling(rng), lambda: f"rotate {rng.vec(-90, 90)}", lambda: f"translate {rng.vec(-1, 1)}",
                    lambda: "matrix <1, 0.3, 0, -0.2, 1, 0.1, 0.1, 0, 1, 0, 0.3, 0>")


def color(rng):
    return f"rgbft <{rng.num(0, 1)}, {rng.num(0, 1)}, {rng.num(0, 1)}, {rng.pick(0, 0, 0.3, 0.8)}, {rng.pick(0, 0, 0.3, 0.7)}>"


def of_pattern(rng):
    return rng.made(lambda: move(rng), lambda: f"turbulence {rng.pick('0.2', '0.7', '<0.3, 0.1, 0.8>')}", lambda: f"frequency {rng.pick(2, 0.5, -1)}",
                    lambda: f"phase {rng.pick(0.3, 0.7)}", lambda: rng.pick("sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave 2"),
                    lambda: f"warp {{ turbulence {rng.vec(-1, 1)} octaves {rng.whole(1, 5)} }}", lambda: f"warp {{ {rng.pick('planar', 'spherical', 'cylindrical')} }}",
                    lambda: f"warp {{ repeat {axis(rng)} offset {rng.vec(-0.5, 0.5)} flip {axis(rng)} }}",
                    lambda: f"warp {{ black_hole {rng.vec(-1, 1)}, {rng.pick(0.5, 1.5)} strength 1.2 falloff 2 }}")


def pigment(rng):
    three = f"[0 {color(rng)}] [0.5 {color(rng)}] [1 {color(rng)}]"
    return rng.pick(f"pigment {{ {color(rng)} }}", f"pigment {{ checker {color(rng)}, {color(rng)} scale {rng.pick(0.2, 0.5, 3)} }}",
                    f"pigment {{ {rng.pick(*PATTERNS)} color_map {{ {three} }} {of_pattern(rng)} }}",
                    f"pigment {{ gradient {axis(rng)} pigment_map {{ [0 {color(rng)}] [0.4 {rng.pick(*PATTERNS)}] [1 {color(rng)}] }} {of_pattern(rng)} }}")


def normal(rng):
    return f"normal {{ {rng.pick(*PATTERNS)} {rng.pick(0.2, 0.5, 1)} {of_pattern(rng)} }}"


def of_finish(rng):
    return rng.made(lambda: f"{rng.pick('ambient', 'diffuse', 'emission', 'phong', 'specular', 'metallic')} {rng.num(0, 1)}",
                    lambda: f"phong_size {rng.pick(5, 100)}", lambda: f"roughness {rng.pick(0.1, 0.01)}", lambda: f"brilliance {rng.pick(0.5, 2, 5)}",
                    lambda: f"reflection {rng.num(0, 0.6)}", lambda: "reflection { 0.1, 0.8 fresnel on } conserve_energy",
                    lambda: "reflection { 0.4 falloff 2 metallic 0.5 }", lambda: "irid { 0.3 thickness 0.4 turbulence 0.2 }",
                    lambda: "diffuse albedo 0.6", lambda: "diffuse 0.5, 0.4")


def finish(rng):
    return "finish { " + " ".join(of_finish(rng) for _ in range(rng.whole(1, 3))) + " }"


def texture(rng):
    return f"texture {{ {pigment(rng)} {rng.some(0.4, normal(rng))} {rng.some(0.6, finish(rng))} }}"


def of_interior(rng):
    return rng.made(lambda: f"ior {rng.pick(1.1, 1.33, 1.5, 2)}", lambda: "caustics 0.5", lambda: f"fade_distance {rng.pick(0.5, 3)} fade_power {rng.pick(1, 2)}",
                    lambda: f"fade_color {color(rng)}", lambda: "dispersion 1.05 dispersion_samples 4")


def solid(rng):
    return rng.pick(f"sphere {{ {rng.vec(-1, 1)}, {rng.pick(0.5, 1, 2)} }}", f"box {{ {rng.vec(-1, 1)} - 0.6, {rng.vec(-1, 1)} + 0.6 }}",
                    f"cylinder {{ {rng.vec(-1, 1)}, {rng.vec(-1, 1)} + y, {rng.pick(0.3, 0.8)} }}", f"plane {{ {rng.vec(-1, 1)} + 0.01*x, {rng.num(-0.5, 1)} }}",
                    f"cone {{ {rng.vec(-1, 1)}, 0.7, {rng.vec(-1, 1)} + 2*y, 0.1 }}", f"torus {{ 0.8, 0.3 rotate {rng.vec(-90, 90)} }}")


def of_object(rng):
    return rng.made(lambda: rng.pick("no_shadow", "inverse", "hollow", "no_image", "no_reflection", "double_illuminate", "uv_mapping", "sturm"),
                    lambda: f"clipped_by {{ {solid(rng)} }}", lambda: move(rng), lambda: texture(rng), lambda: pigment(rng), lambda: normal(rng),
                    lambda: finish(rng), lambda: f"interior {{ {of_interior(rng)} {of_interior(rng)} }}", lambda: f"interior_{texture(rng)}")


def of_light(rng):
    return rng.made(lambda: f"fade_distance {rng.pick(1, 5, 30)} fade_power {rng.pick(0.5, 1, 2)}", lambda: "shadowless", lambda: f"parallel point_at {rng.vec(-1, 1)}",
                    lambda: f"spotlight radius {rng.pick(10, 30)} falloff {rng.pick(20, 50)} tightness {rng.pick(0, 2, 20)} point_at {rng.vec(-1, 1)}",
                    lambda: f"cylinder radius {rng.pick(2, 10)} falloff {rng.pick(5, 20)} point_at {rng.vec(-1, 1)}", lambda: move(rng),
                    lambda: f"area_light {rng.whole(1, 5)}*x, {rng.whole(1, 5)}*y, {rng.whole(1, 4)}, {rng.whole(2, 4)} {rng.pick('', 'adaptive 1', 'circular orient', 'area_illumination')}",
                    lambda: f"looks_like {{ {solid(rng)} {of_object(rng)} }}", lambda: f"projected_through {{ {solid(rng)} }}")


def of_camera(rng):
    return rng.made(lambda: f"angle {rng.pick(20, 60, 100)}", lambda: move(rng), lambda: rng.pick("orthographic", "spherical", "omnimax", "cylinder 2"),
                    lambda: f"{rng.pick('fisheye', 'ultra_wide_angle', 'panoramic', 'cylinder 1', 'cylinder 3')} angle {rng.pick(90, 150)}",
                    lambda: normal(rng), lambda: f"look_at {rng.vec(-1, 1)}", lambda: f"right {rng.pick(-1.33, 1, 2)}*x")


def of_media(rng):
    return rng.made(lambda: f"{rng.pick('absorption', 'emission')} {rng.pick(0.1, 0.5)}", lambda: f"samples {rng.whole(2, 20)}", lambda: "method 3",
                    lambda: f"scattering {{ {rng.whole(1, 5)}, {rng.pick(0.1, 0.3)} {rng.pick('', 'extinction 0.5')} }}",
                    lambda: f"density {{ {rng.pick(*PATTERNS)} density_map {{ [0 rgb 0] [1 rgb 1] }} }}")


def of_fog(rng):
    return rng.made(lambda: f"distance {rng.pick(3, 20)}", lambda: f"fog_type 2 fog_offset {rng.num(0, 1)} {rng.pick('', 'fog_alt 0.5')}",
                    lambda: "turbulence 0.3 turb_depth 0.4", lambda: color(rng), lambda: "up x")


def of_settings(rng):
    return rng.made(lambda: f"assumed_gamma {rng.pick('1', '1.8', '2.2')}", lambda: f"max_trace_level {rng.whole(1, 8)}", lambda: f"adc_bailout {rng.pick(0.1, 0.01)}",
                    lambda: f"ambient_light {rng.pick(0, 0.5, 2)}", lambda: f"number_of_waves {rng.whole(1, 12)}", lambda: f"noise_generator {rng.whole(1, 3)}")


TO_BLOCK = {**dict.fromkeys(SOLIDS, of_object), "pigment": of_pattern, "normal": of_pattern, "density": of_pattern, "finish": of_finish,
            "texture": lambda rng: rng.made(lambda: move(rng), lambda: finish(rng), lambda: normal(rng), lambda: pigment(rng)),
            "interior": of_interior, "light_source": of_light, "camera": of_camera, "media": of_media, "fog": of_fog, "global_settings": of_settings,
            "sky_sphere": lambda rng: rng.made(lambda: pigment(rng), lambda: move(rng))}


def to_scene(rng):
    """A statement of its own."""
    return rng.made(lambda: f"fog {{ distance {rng.pick(5, 30)} {color(rng)} {of_fog(rng)} }}", lambda: f"background {{ {color(rng)} }}",
                    lambda: f"sky_sphere {{ {pigment(rng)} {move(rng)} }}", lambda: f"light_source {{ {rng.vec(-20, 20)}, rgb {rng.pick(0.3, 1)} {of_light(rng)} }}",
                    lambda: f"object {{ {solid(rng)} {texture(rng)} {of_object(rng)} }}", lambda: f"#default {{ {rng.pick(finish(rng), pigment(rng))} }}",
                    lambda: f"global_settings {{ {of_settings(rng)} }}", lambda: f"#version {rng.pick('3.0', '3.1', '3.5', '3.6', '3.7')};",
                    lambda: f"{rng.pick('union', 'merge', 'intersection', 'difference')} {{ {solid(rng)} {solid(rng)} {solid(rng)} {texture(rng)} {of_object(rng)} }}",
                    lambda: f"difference {{ {solid(rng)} {texture(rng)} {solid(rng)} {texture(rng)} {rng.pick('', 'cutaway_textures')} {of_object(rng)} }}")
