#include "info_command.h"

#include "console.h"
#include "measurement.h"
#include "texts.h"
#include "value_report.h"

namespace lds::ctl {

using catalog::ItemId;

namespace {

Target targetOf(ItemId item) { return {QString::fromLatin1(catalog::hlG2(item).key), {item}}; }

QString listOrNone(const QStringList& words)
{
    return words.isEmpty() ? Texts::tr("none") : words.join(QStringLiteral(", "));
}

} // namespace

void InfoCommand::onReady()
{
    if (session().modelContradicted()) {
        console().message(Texts::tr("The sensor holds values that a %1 cannot have; it may be: %2. Correct "
                                    "?sensor= in the URL.")
                              .arg(QString::fromLatin1(session().catalog().model(session().model()).typeName),
                                   listOrNone(typesThatFit())));
    }
    line().json ? printJson() : printLines();
    finish(ExitCode::Done);
}

QString InfoCommand::words(ItemId item)
{
    const Target target = targetOf(item);
    const QString value = valueWords(target, session().model(), session().heldValues());
    const QString unit = unitOf(target, session().heldValues());
    return unit.isEmpty() ? value : value + u' ' + unit;
}

QStringList InfoCommand::setCoils(ItemId status)
{
    // The four status registers hold the 64 coils in order (§5.2.5).
    constexpr std::size_t bitsPerRegister = 16;
    const auto place = std::size_t(status) - std::size_t(ItemId::SensorState);
    const auto coils = session().catalog().coils().subspan(place * bitsPerRegister, bitsPerRegister);
    const auto bits = quint16(session().held(status).value_or(0));
    QStringList keys;
    for (std::size_t bit = 0; bit < bitsPerRegister; ++bit) {
        if ((bits & (1U << bit)) && !coils[bit].reserved())
            keys += QString::fromLatin1(coils[bit].key);
    }
    return keys;
}

QStringList InfoCommand::selfMonitoring()
{
    return setCoils(ItemId::SelfMonitoringNotification) + setCoils(ItemId::SelfMonitoringCaution) +
           setCoils(ItemId::SelfMonitoringError);
}

QStringList InfoCommand::typesThatFit()
{
    QStringList names;
    for (const catalog::ModelDescription& model : session().catalog().models()) {
        if (session().modelsThatFit() & catalog::maskOf(model.model))
            names += QString::fromLatin1(model.typeName);
    }
    return names;
}

void InfoCommand::printJson()
{
    const auto model = session().model();
    const auto& values = session().heldValues();
    QJsonObject object{
        {QStringLiteral("url"), session().url().toString()},
        {QStringLiteral("sensor"), QString::fromLatin1(session().catalog().model(model).typeName)},
        {QStringLiteral("sensorIsStated"), session().modelIsStated()},
        {QStringLiteral("sensorsThatFit"), QJsonArray::fromStringList(typesThatFit())},
        {QStringLiteral("lowWordFirst"), session().linkReport().lowWordFirst},
        {QStringLiteral("state"), QJsonArray::fromStringList(setCoils(ItemId::SensorState))},
        {QStringLiteral("selfMonitoring"), QJsonArray::fromStringList(selfMonitoring())}};
    for (const ItemId item : {ItemId::BankSwitching, ItemId::LaserStop, ItemId::KeyLock, ItemId::ErrorCode,
                              ItemId::MeasuredValue, ItemId::PeakIntensity})
        object.insert(targetOf(item).key, valueJson(targetOf(item), model, values));
    console().json(object);
}

void InfoCommand::printLines()
{
    const QString type = QString::fromLatin1(session().catalog().model(session().model()).typeName);
    const QStringList fit = typesThatFit();
    QString sensor = type;
    if (!session().modelIsStated()) {
        sensor = fit.size() == 1
                     ? Texts::tr("%1 (by its settings)").arg(type)
                     : Texts::tr("one of %1 (by its settings; taken as %2, say which with ?sensor=)")
                           .arg(fit.join(QStringLiteral(", ")), type);
    }
    const QList<QStringList> rows{{Texts::tr("URL"), session().url().toString()},
                                  {Texts::tr("Sensor"), sensor},
                                  {Texts::tr("Bank"), words(ItemId::BankSwitching)},
                                  {Texts::tr("Laser stop"), words(ItemId::LaserStop)},
                                  {Texts::tr("Key lock"), words(ItemId::KeyLock)},
                                  {Texts::tr("State"), listOrNone(setCoils(ItemId::SensorState))},
                                  {Texts::tr("Self-monitoring"), listOrNone(selfMonitoring())},
                                  {Texts::tr("Error code"), words(ItemId::ErrorCode)},
                                  {Texts::tr("Measured value"), words(ItemId::MeasuredValue)},
                                  {Texts::tr("Peak intensity"), words(ItemId::PeakIntensity)},
                                  {Texts::tr("Word order"), session().linkReport().lowWordFirst
                                                                ? Texts::tr("low word first")
                                                                : Texts::tr("high word first")}};
    const QStringList lines = alignedLines(rows);
    for (const QString& text : lines)
        console().line(text);
}

} // namespace lds::ctl
