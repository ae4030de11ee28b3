#pragma once

#include "scene.h"

#include <memory>
#include <QByteArray>
#include <QTest>

namespace lds::emulator::test {

constexpr qint64 ms = 1'000'000; ///< ns
constexpr Nanometres mm = 1'000'000;

/// A scene file of these workpieces and this motion; `rest` begins with a comma.
inline QByteArray sceneJson(const QByteArray& workpieces, const QByteArray& motion,
                            const QByteArray& rest = {})
{
    return R"({"format": "lds-scene", "version": 1, "name": "Test", "description": "A test.", "workpieces": [)" +
           workpieces + R"(], "motion": )" + motion + rest + '}';
}

/// The scene; a null pointer, and a message, when it is refused.
inline std::shared_ptr<const Scene> sceneOf(const QByteArray& json,
                                            catalog::SensorModel model = catalog::SensorModel::HlG203)
{
    const auto scene = Scene::fromJson(json, model);
    if (!scene)
        qWarning("refused: %s", qPrintable(scene.error()));
    return scene.value_or(nullptr);
}

/// What a scene is refused with; empty when it is taken.
inline QString errorOf(const QByteArray& json)
{
    const auto scene = Scene::fromJson(json, catalog::SensorModel::HlG203);
    return scene ? QString() : scene.error();
}

/// A scene with every field there is.
QByteArray fullScene();

} // namespace lds::emulator::test
