#include "scene_fixture.h"

namespace lds::emulator::test {

QByteArray fullScene()
{
    return R"({
  "format": "lds-scene",
  "version": 1,
  "name": "Everything",
  "description": "Every field of a conveyor's scene.",
  "unit": "mm",
  "noise": 0.001,
  "seed": 7,
  "ambientLight": {
    "level": 0.1,
    "intervals": [{ "level": 2, "atMs": 500, "forMs": 100, "everyMs": 1000 }]
  },
  "workpieces": [
    { "name": "flat", "height": 0.5, "length": 10, "reflectance": 0.9 },
    {
      "name": "stepped",
      "profile": [[0, 0], [5, 0], [5, 0.2], [10, 0.2]],
      "reflectance": [[0, 1], [5, 1], [5, 0.1]],
      "length": 12,
      "measuringPoint": 7
    }
  ],
  "motion": {
    "kind": "conveyor",
    "speed": 100,
    "order": ["flat", "stepped", null],
    "pitch": 20,
    "background": { "height": -1, "reflectance": 0.3 }
  },
  "faults": [
    { "fault": "noLight", "atMs": 1000, "forMs": 200, "everyMs": 5000 },
    { "fault": "slowAnswers", "atMs": 2000, "milliseconds": 150 },
    { "fault": "saving", "atMs": 3000, "milliseconds": 2500, "everyMs": 10000 }
  ],
  "triggers": [{ "atMs": 100, "forMs": 50, "everyMs": 200 }]
})";
}

} // namespace lds::emulator::test
