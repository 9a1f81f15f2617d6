-- A cabinet of materials: each of them once, on the same body.
--
--   lapidary render cabinet.lua
--   lapidary render cabinet.lua --set only=7    one alone, in its place
--
-- From left to right, from the top row to the bottom one:
--
--   matte, smooth    matte, rough       velvet           phong            emissive
--   gold, polished   copper, satin      metal, brushed   gilt blend       coated copper
--   glass            glass, ground      glass, tinted    thin_glass       diamond
--   coated matte     coated, satin      principled car   principled felt  principled milk

local only = param("only", 0)

local materials = {
  matte "#c8553d",
  matte { "#d9b48f", roughness = 1 },
  velvet { color = "#b01c3c", roughness = 0.35 },
  phong { "#2c6fa8", specular = 0.35, exponent = 60 },
  emissive { radiance = 1.1, temperature = 2700 },

  metal "gold",
  metal { "copper", roughness = 0.25 },
  metal { "aluminium", roughness = 0.45 },
  blend { materials = { metal { "gold", roughness = 0.12 }, matte "#5a1620" }, weight = 0.45 },
  coated { metal { "copper", roughness = 0.35 }, color = "#ffb080" },

  glass "N-BK7",
  glass { "N-BK7", roughness = 0.25 },
  glass { "N-BK7", color = "#4fae8a", distance = 0.7 },
  thin_glass { color = "#f4faff" },
  glass "diamond",

  coated(matte "#1d3f8f"),
  coated { matte "#4d7a3a", roughness = 0.3 },
  principled {
    "#8a0f14", metalness = 0.4, roughness = 0.45, coat = 1, coat_color = "#ffd8d0",
  },
  principled { "#3d4a5c", roughness = 0.8, fuzz = 1, fuzz_color = "#a8c4e8", fuzz_roughness = 0.6 },
  principled { "#f4efe6", roughness = 0.12, transmission = 0.6, ior = 1.4 },
}

local columns, rows, across, rise, deep = 5, 4, 1.3, 1.24, 0.98
local wood = matte "#b59a78"

--- The middle of the bottom of a compartment.
local function place(number)
  local column, row = (number - 1) % columns, (number - 1) // columns
  return (column - (columns - 1) / 2) * across, (rows - 1 - row) * rise
end

local radius = 0.41
--- A ball with a groove about it, on a foot.
local body = sphere { center = { 0, 0, 0.11 + radius }, radius = radius }
  - torus { major_radius = radius, minor_radius = 0.045 }:rotate { x = 24, y = -20 }:translate { 0, 0, 0.11 + radius }
local foot = cylinder { from = { 0, 0, 0 }, to = { 0, 0, 0.1 }, radius = 0.17, material = matte "#3a322b" }

local width, height = columns * across, rows * rise
local cabinet = box { min = { -width / 2 - 0.09, -deep / 2, -0.09 }, max = { width / 2 + 0.09, deep / 2 + 0.09, height + 0.09 } }
-- Written large, in units of its checks.
local check = 0.14
local wall = rectangle {
  center = { 0, 0.5, 0 }, size = { width / check, height / check }, normal = { 0, -1, 0 },
  material = matte(checker { { 0.74, 0.70, 0.64 }, { 0.42, 0.40, 0.37 } }),
}:scale(check):translate { 0, deep / 2 - 0.01 - check / 2, height / 2 }

local objects = {}
for number, material in ipairs(materials) do
  local x, z = place(number)
  cabinet = cabinet - box {
    min = { x - across / 2 + 0.045, -deep, z + 0.045 },
    max = { x + across / 2 - 0.045, deep / 2, z + rise - 0.045 },
  }
  if only == 0 or only == number then
    objects[#objects + 1] = foot:translate { x, 0, z + 0.045 }
    objects[#objects + 1] = body:material(material):translate { x, 0, z + 0.045 }
  end
end

return scene {
  camera = perspective { from = { 0, -17, 2.9 }, at = { 0, 0, height / 2 }, fov = 18.2 },
  lights = {
    rectangle_light { center = { -6, -13, 8 }, size = { 11, 8 }, at = { 0, 0, 2 }, radiance = 3.4 },
    rectangle_light { center = { 9, -9, 2 }, size = { 3, 9 }, at = { 0, 0, 2.2 }, radiance = 2.4 },
    environment { color = { 0.62, 0.66, 0.72 } },
  },
  objects = {
    cabinet:material(wood),
    wall,
    objects,
  },
  render = { size = { 1000, 800 }, samples = 256 },
}
