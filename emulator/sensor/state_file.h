#pragma once

#include "self_monitoring.h"
#include "settings_memory.h"

#include <optional>
#include <QString>
#include <tl/expected.hpp>

namespace lds::emulator {

/// What a sensor still knows when its power comes back.
struct SavedState {
    SettingsMemory settings;
    LifeCounters life;
};

/// The saved memory of a virtual sensor in a JSON file, so that it survives the program's end:
///
///     { "format": "lds-emulator-state", "version": 2, "sensor": "HL-G203B-S-MK",
///       "life": { "operatingSeconds": 0, "memoryWrites": 0 }, "inputPolarity": "NPN",
///       "common": { "language": 0, … every common item by its key, in wire units … },
///       "banks": [ { "highSetValue": 50000, …, "zeroCorrectionNm": 0, "tunedBrightness": null },
///                  … four … ] }
///
/// "tunedBrightness" is null or [lowest, highest] in millionths of full brightness.
///
/// Reading is strict: another model, an unknown, missing or illegal field is an error that names it, and
/// then nothing is changed. Writing is atomic.
class StateFile {
public:
    explicit StateFile(QString path);

    const QString& path() const { return m_path; }
    /// What the file holds; nothing when there is no such file yet. The error names file and field.
    tl::expected<std::optional<SavedState>, QString> load(catalog::SensorModel model) const;
    tl::expected<void, QString> save(const SettingsMemory& memory, const LifeCounters& life) const;

private:
    QString m_path;
};

/// The same, as bytes.
QByteArray toStateJson(const SettingsMemory& memory, const LifeCounters& life);
tl::expected<SavedState, QString> fromStateJson(const QByteArray& json, catalog::SensorModel model);

} // namespace lds::emulator
