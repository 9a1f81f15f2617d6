-- Materials: what the surfaces of this version look like, on a flight of six steps.
--
--   lapidary render materials.lua
--   lapidary render materials.lua --set row=metals    only one step
--
-- From the front step to the back one, each from left to right:
--
--   glass      water, N-BK7, diamond; then ground glass of roughness 0.1, 0.2 and 0.3
--   metals     gold, silver, copper, aluminium; then two coloured ones; polished
--   satin      the same six, roughness 0.15
--   brushed    an aluminium ball with grooves along its parallels, along its meridians, and aslant;
--              then discs turned on a lathe: of steel, of bronze under varnish, of plastic
--   matte      six colours
--   emissive   bodies that glow at 1900, 2700, 3600, 5000, 6500 and 12000 kelvin

local only = param("row", "all")

local function metals(roughness)
  local balls = {}
  for i, name in ipairs { "gold", "silver", "copper", "aluminium" } do
    balls[i] = metal { name, roughness = roughness }
  end
  balls[5] = metal { color = "#8c2f39", roughness = roughness }
  balls[6] = metal { color = "#2f6f8f", roughness = roughness }
  return balls
end

local function mattes(colors)
  local balls = {}
  for i, color in ipairs(colors) do balls[i] = matte(color) end
  return balls
end

local function glowing(temperatures)
  local balls = {}
  for i, kelvin in ipairs(temperatures) do
    balls[i] = emissive { radiance = 1.1, temperature = kelvin }
  end
  return balls
end

--- Grooves run across the direction in which highlights are long: `angle` is from the parallels.
local function grooved(angle)
  return metal { "aluminium", roughness = 0.4, anisotropy = 0.9, anisotropy_rotation = angle }
end

--- A disc with grooves around its centre, so that highlights are long towards it; it leans back on
--- the step instead of a ball.
local around = gradient { mapping = "cylindrical" } * 360
local function turned(material)
  return function(x, y, z)
    return disk { radius = 0.55, material = material }:rotate { 50, 0, 0 }:translate { x, y, z + 0.45 }
  end
end

local rows = {
  { "glass", {
    glass "water", glass "N-BK7", glass "diamond",
    glass { roughness = 0.1 }, glass { roughness = 0.2 }, glass { roughness = 0.3 },
  } },
  { "metals", metals(0) },
  { "satin", metals(0.15) },
  { "brushed", {
    grooved(90), grooved(0), grooved(45),
    turned(metal { color = "#b9b4ac", roughness = 0.4, anisotropy = 0.9, anisotropy_rotation = around }),
    turned(principled {
      "#d08a50", metalness = 1, roughness = 0.45, anisotropy = 0.9,
      anisotropy_rotation = around, coat = 1,
    }),
    turned(principled {
      "#20304a", roughness = 0.35, anisotropy = 0.95, anisotropy_rotation = around,
    }),
  } },
  { "matte", mattes { "#c8553d", "#d9a441", "#6a994e", "#3a86a8", "#5f5aa2", "#b5838d" } },
  { "emissive", glowing { 1900, 2700, 3600, 5000, 6500, 12000 } },
}

local radius, across, deep, rise = 0.46, 1.24, 1.3, 0.74
local light, dark = matte "#c2bbb0", matte "#3c3936"

--- Every other square of a chessboard on the tread of a step.
local function squares(y, z)
  local vertices, faces, side = {}, {}, across / 4
  for j = 0, 3 do
    for i = -26, 25 do
      if (i + j) % 2 == 0 then
        local n, x0, y0 = #vertices, i * side, y - deep / 2 + j * side
        vertices[n + 1] = { x0, y0, z }
        vertices[n + 2] = { x0 + side, y0, z }
        vertices[n + 3] = { x0 + side, y0 + side, z }
        vertices[n + 4] = { x0, y0 + side, z }
        faces[#faces + 1] = { n + 1, n + 2, n + 3, n + 4 }
      end
    end
  end
  return mesh { vertices = vertices, faces = faces, material = dark }
end

--- One step with its balls; step 1 is the front one.
local function step(number, balls)
  local y, top = (number - 1) * deep, number * rise
  local parts = {
    box { min = { -8, y - deep / 2, 0 }, max = { 8, y + deep / 2, top }, material = light },
    squares(y, top + 0.001),
  }
  for i, material in ipairs(balls) do
    local x = (i - (#balls + 1) / 2) * across
    parts[#parts + 1] = type(material) == "function" and material(x, y, top + 0.15) or sphere {
      center = { x, y, top + 0.002 + radius }, radius = radius, material = material,
    }
  end
  return parts
end

local objects = {}
for number, row in ipairs(rows) do
  local name, balls = row[1], row[2]
  objects[number] = step(number, (only == "all" or only == name) and balls or {})
end

return scene {
  camera = perspective { from = { 0, -17, 10.4 }, at = { 0, 3.1, 2.7 }, fov = 18.6 },
  lights = {
    rectangle_light { center = { -11, -5, 11 }, size = { 18, 12 }, at = { 0, 2, 2 }, radiance = 2 },
    rectangle_light { center = { 11, 0, 7 }, size = { 3, 9 }, at = { 0, 3, 2 }, radiance = 2 },
    environment { color = { 0.36, 0.38, 0.41 } },
  },
  objects = {
    objects,
    plane { material = dark },
    rectangle { center = { 0, 9, 6 }, size = { 60, 20 }, normal = { 0, -1, 0 }, material = light },
  },
  render = { size = { 960, 720 }, samples = 224 },
}
