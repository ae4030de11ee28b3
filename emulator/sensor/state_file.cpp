#include "state_file.h"

#include "write_judge.h"

#include <cmath>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QSet>

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

constexpr auto formatName = "lds-emulator-state"_L1;
constexpr int formatVersion = 2;
constexpr qint64 largestFile = 256 * 1024;
constexpr auto zeroCorrectionKey = "zeroCorrectionNm"_L1;
constexpr auto tunedBrightnessKey = "tunedBrightness"_L1;
constexpr auto inputPolarityKey = "inputPolarity"_L1;
constexpr auto lifeKey = "life"_L1;
constexpr auto operatingSecondsKey = "operatingSeconds"_L1;
constexpr auto memoryWritesKey = "memoryWrites"_L1;
constexpr qint64 mostCounted = 1'000'000'000'000; ///< Of seconds or writes: nobody lives that long.
/// No workpiece is measured farther away than this.
constexpr Nanometres largestCorrection = 2'000'000'000;

using Loaded = tl::expected<void, QString>;

tl::unexpected<QString> problem(const QString& field, const QString& what)
{
    return tl::unexpected(u"%1: %2"_s.arg(field, what));
}

QString keyOf(const SettingItem& item) { return QString::fromLatin1(item.key); }

/// A whole number within the limits; nothing else counts as a number here.
tl::expected<qint64, QString> wholeNumber(const QJsonValue& value, const QString& field, qint64 minimum,
                                          qint64 maximum)
{
    if (!value.isDouble() || value.toDouble() != std::floor(value.toDouble()))
        return problem(field, u"has to be a whole number"_s);
    const double number = value.toDouble();
    if (number < double(minimum) || number > double(maximum))
        return problem(field, u"%1 is outside %2 to %3"_s.arg(number, 0, 'f', 0).arg(minimum).arg(maximum));
    return qint64(number);
}

/// Every key of `object` is one of `known`, and every one of `known` is there.
Loaded checkKeys(const QJsonObject& object, const QString& where, const QSet<QString>& known)
{
    const QString prefix = where.isEmpty() ? QString() : where + u'.';
    const QStringList keys = object.keys();
    for (const QString& key : keys) {
        if (!known.contains(key))
            return problem(prefix + key, u"is not a field of this file"_s);
    }
    QStringList wanted(known.begin(), known.end());
    wanted.sort();
    for (const QString& key : wanted) {
        if (!object.contains(key))
            return problem(prefix + key, u"is missing"_s);
    }
    return {};
}

Loaded loadValues(const QJsonObject& object, const QString& where, Scope scope, int bank,
                  SettingsMemory& memory)
{
    QSet<QString> known;
    if (scope == Scope::Bank)
        known += {zeroCorrectionKey, tunedBrightnessKey};
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (SettingsMemory::holds(item) && item.scope == scope)
            known.insert(keyOf(item));
    }
    if (const Loaded checked = checkKeys(object, where, known); !checked)
        return checked;
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (!SettingsMemory::holds(item) || item.scope != scope)
            continue;
        const QString field = where + u'.' + keyOf(item);
        const auto number = wholeNumber(object.value(keyOf(item)), field, INT_MIN, INT_MAX);
        if (!number)
            return tl::unexpected(number.error());
        const auto judged = judgeValue(memory.model(), {item.id, Value(*number)});
        if (!judged)
            return problem(field, judged.error().reason);
        if (*judged != *number)
            return problem(field, u"%1 is finer than the sensor's resolution"_s.arg(*number));
        memory.setValue(item.id, *judged, bank);
    }
    return {};
}

Loaded loadTunedBrightness(const QJsonValue& value, const QString& field, int bank, SettingsMemory& memory)
{
    if (value.isNull())
        return {};
    const QJsonArray range = value.toArray();
    if (range.size() != 2)
        return problem(field, u"has to be null or [lowest, highest]"_s);
    const auto lowest = wholeNumber(range.at(0), field + u"[0]"_s, 0, LightReceiver::fullBrightness);
    if (!lowest)
        return tl::unexpected(lowest.error());
    const auto highest = wholeNumber(range.at(1), field + u"[1]"_s, *lowest, LightReceiver::fullBrightness);
    if (!highest)
        return tl::unexpected(highest.error());
    memory.setTunedBrightness(bank, BrightnessRange{int(*lowest), int(*highest)});
    return {};
}

Loaded loadBank(const QJsonValue& value, int bank, SettingsMemory& memory)
{
    const QString where = u"banks[%1]"_s.arg(bank);
    if (!value.isObject())
        return problem(where, u"has to be an object"_s);
    const QJsonObject object = value.toObject();
    if (const Loaded loaded = loadValues(object, where, Scope::Bank, bank, memory); !loaded)
        return loaded;
    const auto correction = wholeNumber(object.value(zeroCorrectionKey), where + u'.' + zeroCorrectionKey,
                                        -largestCorrection, largestCorrection);
    if (!correction)
        return tl::unexpected(correction.error());
    memory.setZeroCorrection(bank, *correction);
    if (const Loaded tuned = loadTunedBrightness(object.value(tunedBrightnessKey),
                                                 where + u'.' + tunedBrightnessKey, bank, memory);
        !tuned)
        return tuned;
    if (const auto stored = judgeStored(memory, bank); !stored) {
        const ItemId item = stored.error().item;
        const QString part = SettingsMemory::isBanked(item) ? where : u"common"_s;
        return problem(part + u'.' + keyOf(hlG2(item)), stored.error().reason);
    }
    return {};
}

Loaded checkStamp(const QJsonObject& root, SensorModel model)
{
    if (root.value("format"_L1) != QJsonValue(formatName))
        return problem(u"format"_s, u"has to be \"%1\""_s.arg(formatName));
    if (root.value("version"_L1) != QJsonValue(formatVersion))
        return problem(u"version"_s, u"this program reads version %1"_s.arg(formatVersion));
    const QString expected = QString::fromLatin1(Catalog::hlG2().model(model).typeName);
    if (root.value("sensor"_L1) != QJsonValue(expected)) {
        return problem(u"sensor"_s, u"the file belongs to \"%1\", not to %2"_s.arg(
                                        root.value("sensor"_L1).toString(), expected));
    }
    return {};
}

tl::expected<InputPolarity, QString> polarityOf(const QJsonValue& value)
{
    if (value == QJsonValue(u"NPN"_s))
        return InputPolarity::Npn;
    if (value == QJsonValue(u"PNP"_s))
        return InputPolarity::Pnp;
    return problem(inputPolarityKey, u"has to be \"NPN\" or \"PNP\""_s);
}

tl::expected<LifeCounters, QString> lifeOf(const QJsonValue& value)
{
    const QJsonObject object = value.toObject();
    if (const Loaded keys = checkKeys(object, lifeKey, {operatingSecondsKey, memoryWritesKey}); !keys)
        return tl::unexpected(keys.error());
    const QString prefix = lifeKey + u'.';
    const auto seconds =
        wholeNumber(object.value(operatingSecondsKey), prefix + operatingSecondsKey, 0, mostCounted);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto writes = wholeNumber(object.value(memoryWritesKey), prefix + memoryWritesKey, 0, mostCounted);
    if (!writes)
        return tl::unexpected(writes.error());
    return LifeCounters{*seconds, *writes};
}

QJsonValue tunedBrightnessJson(const std::optional<BrightnessRange>& range)
{
    return range ? QJsonValue(QJsonArray{range->lowest, range->highest}) : QJsonValue();
}

} // namespace

QByteArray toStateJson(const SettingsMemory& memory, const LifeCounters& life)
{
    QJsonObject common;
    std::array<QJsonObject, SettingsMemory::bankCount> banks;
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (!SettingsMemory::holds(item))
            continue;
        if (item.scope == Scope::Common)
            common.insert(keyOf(item), memory.value(item.id));
        for (int bank = 0; item.scope == Scope::Bank && bank < SettingsMemory::bankCount; ++bank)
            banks[std::size_t(bank)].insert(keyOf(item), memory.value(item.id, bank));
    }
    QJsonArray bankArray;
    for (int bank = 0; bank < SettingsMemory::bankCount; ++bank) {
        banks[std::size_t(bank)].insert(zeroCorrectionKey, memory.zeroCorrection(bank));
        banks[std::size_t(bank)].insert(tunedBrightnessKey,
                                        tunedBrightnessJson(memory.tunedBrightness(bank)));
        bankArray.append(banks[std::size_t(bank)]);
    }
    const QString sensor = QString::fromLatin1(Catalog::hlG2().model(memory.model()).typeName);
    return QJsonDocument(QJsonObject{{u"format"_s, formatName},
                                     {u"version"_s, formatVersion},
                                     {u"sensor"_s, sensor},
                                     {lifeKey, QJsonObject{{operatingSecondsKey, life.operatingSeconds},
                                                           {memoryWritesKey, life.memoryWrites}}},
                                     {inputPolarityKey,
                                      memory.inputPolarity() == InputPolarity::Npn ? u"NPN"_s : u"PNP"_s},
                                     {u"common"_s, common},
                                     {u"banks"_s, bankArray}})
        .toJson();
}

tl::expected<SavedState, QString> fromStateJson(const QByteArray& json, SensorModel model)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return tl::unexpected(u"is not JSON: %1 at byte %2"_s.arg(error.errorString()).arg(error.offset));
    if (!document.isObject())
        return tl::unexpected(u"has to be one JSON object"_s);
    const QJsonObject root = document.object();
    if (const Loaded stamped = checkStamp(root, model); !stamped)
        return tl::unexpected(stamped.error());
    if (const Loaded keys = checkKeys(
            root, {},
            {u"format"_s, u"version"_s, u"sensor"_s, lifeKey, inputPolarityKey, u"common"_s, u"banks"_s});
        !keys)
        return tl::unexpected(keys.error());
    if (!root.value("common"_L1).isObject())
        return problem(u"common"_s, u"has to be an object"_s);
    const QJsonArray banks = root.value("banks"_L1).toArray();
    if (banks.size() != SettingsMemory::bankCount)
        return problem(u"banks"_s, u"has to be a list of %1 banks"_s.arg(SettingsMemory::bankCount));

    const auto life = lifeOf(root.value(lifeKey));
    if (!life)
        return tl::unexpected(life.error());
    const auto polarity = polarityOf(root.value(inputPolarityKey));
    if (!polarity)
        return tl::unexpected(polarity.error());
    SettingsMemory memory(model);
    memory.setInputPolarity(*polarity);
    Loaded loaded = loadValues(root.value("common"_L1).toObject(), u"common"_s, Scope::Common, 0, memory);
    for (int bank = 0; loaded && bank < SettingsMemory::bankCount; ++bank)
        loaded = loadBank(banks.at(bank), bank, memory);
    if (!loaded)
        return tl::unexpected(loaded.error());
    return SavedState{memory, *life};
}

StateFile::StateFile(QString path)
    : m_path(std::move(path))
{}

tl::expected<std::optional<SavedState>, QString> StateFile::load(SensorModel model) const
{
    QFile file(m_path);
    if (!file.exists())
        return std::nullopt;
    if (!file.open(QIODevice::ReadOnly))
        return problem(m_path, file.errorString());
    const QByteArray json = file.read(largestFile + 1);
    if (json.size() > largestFile)
        return problem(m_path, u"is larger than %1 bytes and no state file"_s.arg(largestFile));
    auto state = fromStateJson(json, model);
    if (!state)
        return problem(m_path, state.error());
    return std::optional(std::move(*state));
}

tl::expected<void, QString> StateFile::save(const SettingsMemory& memory, const LifeCounters& life) const
{
    QSaveFile file(m_path);
    if (!file.open(QIODevice::WriteOnly))
        return problem(m_path, file.errorString());
    file.write(toStateJson(memory, life));
    if (!file.commit())
        return problem(m_path, file.errorString());
    return {};
}

} // namespace lds::emulator
