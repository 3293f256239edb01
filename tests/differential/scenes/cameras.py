"""All cameras with all their vectors, angles, transformations and bent rays, before a stage with things around it."""
from rng import block, lines
from words import common

KINDS = ("perspective", "perspective", "", "orthographic", "orthographic", "fisheye", "ultra_wide_angle", "omnimax", "panoramic",
         "cylinder 1", "cylinder 2", "cylinder 3", "cylinder 4", "spherical", "mesh_camera")


def scene(r):
    parts = [common.HEADER, camera(r), common.background(r), common.floor(r), common.light(r), common.things(r, 3, 6)]
    # Things behind and above, for cameras that see more than half of the world.
    parts += [f"sphere {{ {r.vec(-8, 8)}, {r.num(.5, 2)} {common.pigment(r)} {common.finish(r)} }}" for _ in range(r.whole(1, 4))]
    parts += [r.some(.15, f"fog {{ distance {r.num(5, 30)} {r.color(.4, 1)} }}"),
              r.some(.15, f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 {r.color()}] [1 {r.color()}] }} }} }}")]
    return lines(*parts)


def camera(r):
    kind = r.pick(*KINDS)
    if kind == "mesh_camera":
        return mesh_camera(r)
    where, aim = r.box((-4, 4), (-.5, 4), (-6, -3)), r.vec(-1, 1)
    body = [kind]
    vectors = [f"location {where}"]
    if r.chance(.3):
        vectors += [f"right {r.pick('x', '-x', 'x*image_width/image_height', '<1.3, 0, .2>')}*{r.num(.6, 1.6)}"]
    if r.chance(.25):
        vectors += [f"up {r.pick('y', 'y', '-y', '<.1, 1, 0>')}*{r.num(.6, 1.4)}"]
    if r.chance(.25):
        vectors += [f"direction z*{r.num(.5, 3)}"]
    if r.chance(.2):
        vectors += [f"sky {r.pick('z', 'x', '<.2, 1, .3>', '-y')}"]
    look = [r.some(.9, f"look_at {aim}")]
    opening = angle(r, kind)
    if kind == "orthographic" and not opening and len(vectors) < 3:
        vectors += [f"right x*{r.num(4, 9)}", f"up y*{r.num(3, 7)}"]
    body += vectors + ([opening] + look if r.chance(.3) else look + [opening])
    if r.chance(.15):
        body += [f"normal {{ {r.pick('bumps', 'ripples', 'waves', 'wrinkles', 'gradient x')} {r.num(.05, .4)} scale {r.num(.2, 1)} }}"]
    if r.chance(.2):
        body += [r.pick(f"rotate {r.vec(-30, 30)}", f"translate {r.vec(-.5, .5)}", f"scale {r.num(.7, 1.4)}",
                        f"rotate y*{r.num(-90, 90)}", f"scale {r.vec(.8, 1.2)}")]
    return block("camera", *body)


def angle(r, kind):
    if kind in ("perspective", "", "orthographic"):
        return r.some(.6, f"angle {r.num(15, 110)}")
    if kind.startswith("cylinder"):
        return r.some(.7, f"angle {r.num(40, 170)}")
    if kind == "spherical":
        return r.some(.6, f"angle {r.num(60, 360)}" + r.some(.5, f", {r.num(40, 180)}"))
    if kind in ("fisheye", "ultra_wide_angle", "panoramic"):
        return r.some(.7, f"angle {r.num(60, 200 if kind != 'panoramic' else 170)}")
    return ""


def mesh_camera(r):
    """Rays that start in the faces of a small grid, one face a pixel as far as they go."""
    grid = f"""#declare Grid = mesh2 {{
  vertex_vectors {{ 4 <{r.num(-2, -1.6)}, -1, 0>, <2, {r.num(-1.2, -.8)}, 0>, <-2, 1.4, {r.num(-.3, .3)}>, <2, 1.6, {r.num(-.3, .3)}> }}
  face_indices {{ 2 <0, 1, 2>, <1, 3, 2> }}
}}"""
    rays, kind = 1, r.pick(0, 1, 3)
    smooth = r.some(.5, "smooth") if kind == 3 else ""
    return lines(grid, block("camera", f"mesh_camera {{ {rays} {kind} mesh {{ Grid }} {smooth} }}",
                             f"location {r.box((-1, 1), (0, 2), (-6, -4))}", r.some(.5, f"direction {r.vec(-.3, .3)[:-1]} + 1>")))
