-- Lights that are there: balls of light, seen directly, mirrored in the silver and the dull floor,
-- and upside down through the glass. They are objects among others and, but for a dim sky, all the
-- light.

local function globe(x, y, radius, color, brightness)
  return sphere_light {
    center = { x, y, radius }, radius = radius, color = color, radiance = brightness,
    name = "globe",
  }
end

local function ball(x, y, radius, material)
  return sphere { center = { x, y, radius }, radius = radius, material = material }
end

return scene {
  camera = perspective { from = { 0, -9.5, 3.4 }, at = { 0, 0, 0.62 }, fov = 25, fov_axis = "y" },
  lights = {
    globe(-3.3, 1.4, 0.6, "#ff4a2a", 1.4),
    globe(-1.6, 3.6, 0.75, "#ffa033", 1.3),
    globe(0.1, 2.2, 0.42, "#5cff86", 1.1),
    globe(1.9, 4.2, 0.9, "#3f9dff", 1.3),
    globe(3.4, 1.2, 0.55, "#b45cff", 1.4),
    globe(-2.75, -1.9, 0.3, "#ffd089", 1.6),
    globe(2.75, -1.7, 0.28, "#ff4f8f", 1.5),
    globe(-0.7, -2.7, 0.2, "#58e0ff", 1.5),
    globe(-4.5, -7, 1.3, "#ff7a3a", 1.3), -- beside the camera, seen only in the metal
    globe(3.6, -8, 1.1, "#4a8cff", 1.3),
    environment { color = { 0.035, 0.042, 0.07 } },
  },
  objects = {
    plane { material = metal { color = { 0.2, 0.21, 0.23 }, roughness = 0.3 }, name = "floor" },
    ball(-1.15, 0, 1, metal "silver"),
    ball(1.15, -0.5, 0.9, glass(1.5)),
    ball(0.15, -1.9, 0.3, matte "#e8e2d6"),
  },
  render = { size = { 640, 400 }, samples = 96 },
}
