-- A mesh: any may stand here, by --set mesh=duck.obj. Without one it is a pumpkin, a distance from
-- the middle for every longitude and latitude, in 36 000 triangles with smooth normals.
local studio = require "parts.studio"
local surfaces = require "parts.surfaces"

local cos, sin, abs, pi = math.cos, math.sin, math.abs, math.pi

local path = param("mesh", "")     -- a file; nothing for the pumpkin
local size = param("size", 1)      -- the file's mesh is scaled by this
local turn = param("turn", 0)      -- degrees about z

--- Ribs are deepest at the equator and run together in a dent at both poles.
local function pumpkin(ribs, flatness)
  return surfaces.star(function(theta, phi)
    local rib = abs(sin(ribs * theta / 2)) ^ 0.7
    local dent = 1 - 0.5 * abs(sin(phi)) ^ 5
    local lumps = 1 + 0.025 * sin(3 * theta + 1) + 0.015 * sin(7 * theta + 3 * phi)
    return (0.88 + 0.12 * rib * cos(phi) ^ 0.4) * dent * lumps * (1 - flatness * abs(sin(phi)))
  end, 240, 75)
end

--- A five-sided stalk that bends and widens to its foot.
local function stalk()
  return surfaces.sheet(function(u, v)
    local angle = 2 * pi * u
    local radius = (0.085 + 0.09 * (1 - v) ^ 3 + 0.03 * v ^ 6) * (1 + 0.14 * cos(5 * angle + 2 * v))
    return { radius * cos(angle) + 0.16 * v ^ 2, radius * sin(angle), 0.5 * v }
  end, 60, 30, { around = true })
end

local bark = matte(mix("#5d6b35", "#b09a5c", fbm {}:scale(0.1)))

local function fruit(skin, ribs, flatness, lean)
  local body = pumpkin(ribs, flatness)
  local height = (1 - flatness) * 0.5 * 0.88
  return group {
    body:material(skin),
    stalk():translate { z = height - 0.02 }:material(bark),
  }:rotate { y = lean }
end

local clouds = fbm {}:scale { 0.5, 0.5, 0.3 }
local orange = matte(mix("#d9600f", "#f08a24", ramp { clouds, from = 0.35, to = 0.65 }))
local pale = matte(mix("#d8c9a0", "#8d9a72", ramp { fbm {}:scale(0.5), from = 0.4, to = 0.75 }))

local subject = {
  fruit(orange, 11, 0.12, 6):rotate { z = -70 }:scale(1.25):translate { -0.35, 0, 0.81 },
  fruit(pale, 15, 0.3, 14):rotate { z = 200 }:scale(0.62):translate { 1.35, -0.75, 0.375 },
}
if path ~= "" then subject = mesh(path):scale(size):rotate { z = turn } end

return scene {
  camera = perspective { from = { 0, -9, 3.4 }, at = { 0.15, 0, 0.85 }, fov = 20 },
  lights = studio.lights(),
  objects = { subject, studio.floor "#55606b" },
  render = { size = studio.size, samples = 96 },
}
