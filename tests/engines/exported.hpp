// What `lcpush export --format mjcf` says of a scene, and `score.py --engine` around an engine:
// read, step, print.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tinyxml2.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace exported {

using Vector = Eigen::Vector3d;

/// From its body's origin, at the start parallel to the world. `size`, m: half edges of a box,
/// radius and half the length of a cylinder, radius of a sphere.
struct Geom {
  std::string name, type;
  Vector size, center, axis; ///< of a cylinder; the outward normal of a plane or plate

  Eigen::Matrix3d rotation() const {
    return Eigen::Quaterniond::FromTwoVectors(Vector::UnitZ(), axis).toRotationMatrix();
  }
};

/// A body that goes as prescribed, or stands; its finger, if `mass` is not 0, slides on it.
struct Body {
  std::string name;
  std::vector<Geom> geoms;
  Vector velocity = Vector::Zero(), acceleration = Vector::Zero();
  Vector axis = Vector::Zero();
  double mass = 0, inertia = 0, force = 0; ///< kg, kg m^2 about any axis, N along `axis`
  bool is_coupled = false;                 ///< its force is its share of a motor's

  bool is_prescribed() const { return !velocity.isZero(0) || !acceleration.isZero(0); }
  /// The mean of the step from `time` to `time` + `step`.
  Vector mean_velocity(double time, double step) const {
    return velocity + (time + step / 2) * acceleration;
  }
};

struct Pair {
  std::size_t object_geom, body, geom;
  double friction, torsion; ///< torsion, m: the moment about the normal, over the normal force
};

struct Scene {
  Vector gravity, start, velocity, spin; ///< velocity and spin are the object's
  bool is_planar = false;                ///< the object stays in a plane of z
  double mass = 0;
  Eigen::Matrix3d inertia;
  std::vector<Geom> geoms;  ///< the object's
  std::vector<Body> bodies; ///< their origins at `start`
  std::vector<Pair> pairs;  ///< nothing else touches
};

struct State {
  Vector position;
  Eigen::Quaterniond rotation;
  Vector velocity, spin;
  std::vector<Vector> forces; ///< N, of each body on the object in the last step, or on the body
};

inline std::vector<double> numbers(const tinyxml2::XMLElement* element, const char* attribute) {
  const char* text = element == nullptr ? nullptr : element->Attribute(attribute);
  std::istringstream in(text == nullptr ? "" : text);
  std::vector<double> all;
  for (double x; in >> x;) all.push_back(x);
  return all;
}

inline Vector vector(const tinyxml2::XMLElement* element, const char* attribute) {
  std::vector<double> x = numbers(element, attribute);
  x.resize(3);
  return {x[0], x[1], x[2]};
}

template <class Each>
void for_each(const tinyxml2::XMLElement* parent, const char* name, const Each& each) {
  if (parent == nullptr) return;
  for (const auto* e = parent->FirstChildElement(name); e; e = e->NextSiblingElement(name)) each(e);
}

inline std::vector<Geom> geoms_of(const tinyxml2::XMLElement* body) {
  std::vector<Geom> all;
  for_each(body, "geom", [&](const tinyxml2::XMLElement* e) {
    all.push_back({e->Attribute("name"), e->Attribute("type"), vector(e, "size"), vector(e, "pos"),
                   vector(e, "zaxis")});
  });
  return all;
}

/// Objects' masses: what is heavier goes as prescribed, whatever presses on it.
constexpr double heavy = 1e3;

class Reader {
public:
  explicit Reader(const tinyxml2::XMLElement* root) : root_(root) {
    const auto* key = root->FirstChildElement("keyframe")->FirstChildElement("key");
    speeds_ = numbers(key, "qvel");
    const std::vector<double> controls = numbers(key, "ctrl");
    for_each(root->FirstChildElement("actuator"), "motor", [&](const tinyxml2::XMLElement* e) {
      const std::size_t motor = forces_.size();
      forces_[e->Attribute("joint")] = controls.at(motor);
    });
    const std::size_t motors = forces_.size();
    for_each(root->FirstChildElement("actuator"), "general", [&](const tinyxml2::XMLElement* e) {
      const std::size_t servo = motors + accelerations_.size();
      accelerations_[e->Attribute("joint")] = controls.at(servo);
    });
    for_each(root->FirstChildElement("equality"), "joint", [&](const tinyxml2::XMLElement* e) {
      leader_[e->Attribute("joint1")] = e->Attribute("joint2");
      followers_[e->Attribute("joint2")] += numbers(e, "polycoef").at(1);
    });
  }

  Scene scene() {
    const auto* world = root_->FirstChildElement("worldbody");
    Scene scene = object(world->FirstChildElement("body"));
    for_each(world, "body", [&](const tinyxml2::XMLElement* e) {
      if (e == world->FirstChildElement("body")) return;
      Body body;
      add_part(e, scene.mass, body);
      scene.bodies.push_back(body);
    });
    for_each(root_->FirstChildElement("contact"), "pair",
             [&](const tinyxml2::XMLElement* e) { add_pair(e, scene); });
    if (!leader_.empty()) refuse_coupled(scene);
    return scene;
  }

private:
  Scene object(const tinyxml2::XMLElement* body) {
    Scene scene;
    scene.gravity = vector(root_->FirstChildElement("option"), "gravity");
    scene.start = vector(body, "pos");
    scene.is_planar = body->FirstChildElement("freejoint") == nullptr;
    const auto* inertial = body->FirstChildElement("inertial");
    scene.mass = inertial->DoubleAttribute("mass");
    const std::vector<double> I = numbers(inertial, "fullinertia");
    scene.inertia << I.at(0), I.at(3), I.at(4), I[3], I[1], I.at(5), I[4], I[5], I[2];
    scene.geoms = geoms_of(body);
    next_speed_ = scene.is_planar ? 3 : 6;
    scene.velocity = {speeds_.at(0), speeds_.at(1), scene.is_planar ? 0 : speeds_.at(2)};
    scene.spin = scene.is_planar ? Vector(0, 0, speeds_.at(2))
                                 : Vector(speeds_.at(3), speeds_.at(4), speeds_.at(5));
    return scene;
  }

  /// A slide and what it carries. No engine here couples slides: jaws of one motor share its force.
  void add_part(const tinyxml2::XMLElement* part, double object_mass, Body& body) {
    body.name = part->Attribute("name");
    body.geoms = geoms_of(part);
    if (const auto* joint = part->FirstChildElement("joint")) {
      const std::string name = joint->Attribute("name");
      const std::string motor = leader_.count(name) ? leader_[name] : name;
      const double force = forces_[motor] / (1 + followers_[motor]);
      const double speed = speeds_.at(next_speed_++);
      const Vector axis = vector(joint, "axis");
      const auto* own = part->FirstChildElement("inertial");
      const double mass = own->DoubleAttribute("mass");
      if (mass > heavy * object_mass) {
        body.velocity += speed * axis;
        body.acceleration += accelerations_[name] * axis;
      } else {
        if (body.mass > 0) throw std::runtime_error("no finger of two slides: " + body.name);
        body.axis = axis;
        body.mass = mass;
        body.inertia = vector(own, "diaginertia")[0];
        body.force = force;
        body.is_coupled = followers_[motor] > 0;
      }
    }
    for_each(part, "body", [&](const tinyxml2::XMLElement* e) { add_part(e, object_mass, body); });
  }

  /// Jaws that share a force press as coupled ones do, unless something moves the object along
  /// them.
  static void refuse_coupled(const Scene& scene) {
    for (const Body& jaw : scene.bodies)
      for (const Body& body : scene.bodies) {
        if (jaw.mass == 0 || !jaw.is_coupled) continue;
        Vector along = body.velocity + body.acceleration + scene.gravity + scene.velocity;
        if (!body.is_coupled) along += body.force * body.axis;
        if (std::abs(along.dot(jaw.axis)) > 0)
          throw std::runtime_error("no coupling of jaws that the object moves along: " + jaw.name);
      }
  }

  static std::size_t find(const std::vector<Geom>& geoms, const std::string& name) {
    const auto is_it = [&](const Geom& geom) { return geom.name == name; };
    return static_cast<std::size_t>(std::find_if(geoms.begin(), geoms.end(), is_it) -
                                    geoms.begin());
  }

  static void add_pair(const tinyxml2::XMLElement* e, Scene& scene) {
    const std::vector<double> friction = numbers(e, "friction");
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const std::size_t geom = find(scene.bodies[b].geoms, e->Attribute("geom2"));
      if (geom < scene.bodies[b].geoms.size())
        scene.pairs.push_back(
            {find(scene.geoms, e->Attribute("geom1")), b, geom, friction.at(0), friction.at(2)});
    }
  }

  const tinyxml2::XMLElement* root_;
  std::vector<double> speeds_;
  std::size_t next_speed_ = 0;
  std::map<std::string, double> forces_, followers_; ///< by a motor's joint: N; sum of the ratios
  std::map<std::string, double> accelerations_;      ///< m/s^2, by a servo's joint
  std::map<std::string, std::string> leader_;        ///< by a coupled joint
};

/// Of an exported scene.xml; or of a scene, by the tool that LCPUSH names, which says itself what
/// it refuses.
inline Scene scene_of(const std::string& file) {
  tinyxml2::XMLDocument document;
  if (std::filesystem::path(file).extension() == ".xml") {
    document.LoadFile(file.c_str());
    if (document.Error()) throw std::runtime_error(document.ErrorStr());
    return Reader(document.RootElement()).scene();
  }
  const char* tool = std::getenv("LCPUSH");
  if (tool == nullptr) throw std::runtime_error("LCPUSH has to name the tool");
  std::string folder = (std::filesystem::temp_directory_path() / "engine-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no room in " + folder);
  const std::string said = folder + "/said";
  const std::string command = "'" + std::string(tool) + "' export '" + file +
                              "' --format mjcf -o '" + folder + "' 2>'" + said + "'";
  const bool is_there = std::system(command.c_str()) == 0;
  document.LoadFile((folder + "/scene.xml").c_str());
  std::stringstream words;
  words << std::ifstream(said).rdbuf();
  std::filesystem::remove_all(folder);
  if (!is_there || document.Error()) throw std::runtime_error(words.str());
  return Reader(document.RootElement()).scene();
}

inline void print(const Vector& v) { std::printf(",%.12g,%.12g,%.12g", v[0], v[1], v[2]); }

/// [step=S] [OPTION ..] SCENE SECONDS: `World` is made of the scene and the other options, has
/// `step` (from a time on, so long) and `state`. Prints 401 frames, and how long a step took.
template <class World> int run(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("[step=S] [OPTION ..] SCENE SECONDS");
  std::map<std::string, std::string> options{{"step", "5e-5"}};
  for (int k = 1; k < argc - 2; ++k) {
    const std::string word = argv[k];
    options[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  }
  const double seconds = std::stod(argv[argc - 1]), longest = std::stod(options["step"]);
  constexpr int frames = 400;
  const int steps = static_cast<int>(std::ceil(seconds / frames / longest)); // of a frame
  const double step = seconds / frames / steps;
  const Scene scene = scene_of(argv[argc - 2]);
  World world(scene, options);
  std::printf("time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");
  for (const Body& body : scene.bodies)
    for (const char axis : {'x', 'y', 'z'}) std::printf(",%s.f%c", body.name.c_str(), axis);
  std::chrono::duration<double, std::micro> spent{0};
  for (int frame = 0; frame <= frames; ++frame) {
    const State now = world.state();
    const Eigen::Quaterniond& q = now.rotation;
    std::printf("\n%.17g", frame * steps * step);
    print(now.position);
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) std::printf(",%.12g", part);
    print(now.velocity);
    print(now.spin);
    for (const Vector& force : now.forces) print(force);
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < steps && frame < frames; ++k) world.step((frame * steps + k) * step, step);
    spent += std::chrono::steady_clock::now() - start;
  }
  std::puts("");
  std::fprintf(stderr, "%.3g us a step\n", spent.count() / frames / steps);
  return 0;
} catch (const std::exception& refusal) {
  std::fprintf(stderr, "%s\n", refusal.what());
  return 1;
}

} // namespace exported
