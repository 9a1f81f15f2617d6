-- Wine at dusk: wine in one glass, water and ice in another, by a lake under the sky of a clear
-- evening. Liquid, ice and glass overlap as solids; what borders on what follows from that.

local clear = glass(1.5)
local wine = glass { ior = 1.345, color = { 0.42, 0.012, 0.025 }, distance = 0.6 }
local lake = glass { "water", color = { 0.02, 0.06, 0.08 }, distance = 30,
  bump = noise {}:scale { 60, 20, 20 } * 1.5 }
local water, ice = glass(1.333), glass(1.31)

local function below(z) return half_space { point = { 0, 0, z } } end

--- A wine glass: a bowl cut from an egg, on a stem, with wine to `level`.
local function goblet(level)
  local middle, rim = { 0, 0, 2.55 }, 3.35
  local function egg(grow)
    return ellipsoid { center = middle, radii = { 0.9 + grow, 0.9 + grow, 1.15 + grow } }
  end
  local lip = 0.9 * math.sqrt(1 - ((rim - middle[3]) / 1.15) ^ 2)
  local stem = cylinder { from = { 0, 0, 0.1 }, to = { 0, 0, 1.6 }, radius = 0.3 }
    - torus { center = { 0, 0, 0.8 }, major_radius = 0.86, minor_radius = 0.79 }
  local foot = cone { from = { 0, 0, 0.03 }, to = { 0, 0, 0.2 }, radius = 0.78, radius2 = 0.16 }
    + cylinder { from = { 0, 0, 0 }, to = { 0, 0, 0.03 }, radius = 0.78 }
  local vessel = ((egg(0.02) & below(rim)) + stem + foot) - (egg(-0.02) & below(rim + 1))
    + torus { center = { 0, 0, rim }, major_radius = lip, minor_radius = 0.022 }
  return group {
    vessel:material(clear):priority(3),
    (egg(0) & below(level)):material(wine):priority(1),
  }
end

--- A tumbler with a thick bottom, water to `level` and ice.
local function tumbler(level)
  local function inside(grow)
    return cone {
      from = { 0, 0, 0.2 - grow }, to = { 0, 0, 1.9 }, radius = 0.6 + grow, radius2 = 0.72 + grow,
    }
  end
  local outside = cone { from = { 0, 0, 0 }, to = { 0, 0, 1.8 }, radius = 0.64, radius2 = 0.78 }
  local vessel = outside - inside(0)
  local function cube(side)
    return box { size = { side, side, side } } & sphere { radius = 0.78 * side }
  end
  return group {
    vessel:material(clear):priority(3),
    (inside(0.02) & below(level)):material(water):priority(1),
    cube(0.55):rotate { x = 24, y = 18, z = 30 }:translate { -0.22, -0.08, level - 0.14 }
      :material(ice):priority(2),
    cube(0.5):rotate { x = -20, y = 32, z = 10 }:translate { 0.27, 0.22, level - 0.12 }
      :material(ice):priority(2),
    cube(0.46):rotate { x = 40, y = 10, z = 60 }:translate { 0.16, -0.3, level - 0.5 }
      :material(ice):priority(2),
  }
end

-- Planks with a gap between them, each from another place in the tree.
local planks = {}
for i = -6, 6 do
  local timber = wood { colors = { "#b98a5a", "#9c6b3e", "#7a4c28" }, seed = 20 + i }
    :scale(0.3):rotate { y = 86 }:translate { 0, 0.7 + 0.1 * i, -1 }
  planks[#planks + 1] = box { min = { -12, -0.48, -0.3 }, max = { 12, 0.48, 0 } }
    :material(matte(timber)):translate { i % 2, 0.97 * i + 0.3, 0 }
end

return scene {
  unit = "cm",
  camera = perspective {
    from = { 0, -11, 2.9 }, at = { 0.15, 0, 1.75 }, fov = 22, fov_axis = "y",
    aperture = 0.12, focus = { 0, -0.4, 2 },
  },
  lights = { sky { elevation = 3, azimuth = 12, turbidity = 3, sun = false } },
  objects = {
    goblet(2.5):translate { -1.0, 0.2, 0 },
    tumbler(1.45):translate { 1.35, -0.5, 0 },
    planks,
    plane { point = { 0, 0, -40 }, material = lake, name = "lake" },
  },
  render = { size = { 640, 400 }, samples = 80, max_depth = 24 },
  film = { exposure = 0.06 },
}
