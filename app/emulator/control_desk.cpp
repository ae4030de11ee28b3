#include "control_desk.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QStringDecoder>

namespace lds::app {

using namespace Qt::StringLiterals;
using emulator::FaultDesk;
using emulator::SensorStation;
using emulator::StationState;

namespace {

QByteArray jsonLine(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

QByteArray errorLine(const QString& error) { return jsonLine({{u"ok"_s, false}, {u"error"_s, error}}); }

QJsonValue portValue(std::optional<quint16> port) { return port ? QJsonValue(*port) : QJsonValue(); }

QString workpieceText(const StationState& state)
{
    if (!state.heldAt)
        return state.held.isEmpty() ? u"moving"_s : state.held;
    const int value = *state.heldAt;
    return u"at %1%2.%3"_s.arg(value < 0 ? u"-"_s : QString())
        .arg(qAbs(value) / 10'000)
        .arg(qAbs(value) % 10'000, 4, 10, QChar(u'0'));
}

/// Who has something on.
QString by(bool person, bool scene)
{
    if (person && scene)
        return u"both"_s;
    return person ? u"person"_s : u"scene"_s;
}

QJsonArray faultsThatAreOn(const StationState& state)
{
    QJsonArray faults;
    for (const StationState::Fault& fault : state.faults) {
        if (!fault.byPerson && !fault.byScene)
            continue;
        QJsonObject object{{u"name"_s, keyOf(fault.fault)}, {u"by"_s, by(fault.byPerson, fault.byScene)}};
        if (defaultMilliseconds(fault.fault))
            object.insert(u"milliseconds"_s, fault.milliseconds);
        faults.append(object);
    }
    return faults;
}

/// One command on one station; the error says why it could not be done.
struct CarryOut {
    SensorStation& station;
    using Done = tl::expected<void, QString>;

    Done operator()(const ControlCommand::Status&) const { return {}; }
    Done operator()(const ControlCommand::Help&) const { return {}; }
    Done operator()(const ControlCommand::PowerCycle&) const
    {
        station.sensor().powerCycle();
        return {};
    }
    Done operator()(const ControlCommand::Scene& scene) const
    {
        return station.loadScene(scene.pathOrExample);
    }
    Done operator()(const ControlCommand::HoldWorkpiece& workpiece) const
    {
        if (station.player().holdStill(workpiece.name))
            return {};
        QStringList known = station.state().workpieces;
        known += {u"at MM"_s, u"moving"_s};
        return tl::unexpected(u"workpiece: there is no \"%1\" to be seen; there are: %2"_s.arg(
            workpiece.name.left(60), known.join(u", "_s)));
    }
    Done operator()(const ControlCommand::HoldAt& place) const
    {
        station.player().holdAt(place.rawValue);
        return {};
    }
    Done operator()(const ControlCommand::LetMove&) const
    {
        station.player().letMove();
        return {};
    }
    Done operator()(const ControlCommand::Fault& fault) const
    {
        if (fault.on)
            station.faults().switchOn(fault.fault, FaultDesk::By::Person, fault.milliseconds);
        else
            station.faults().switchOff(fault.fault, FaultDesk::By::Person);
        return {};
    }
    Done operator()(const ControlCommand::Trigger& trigger) const
    {
        station.player().setTrigger(trigger.on);
        return {};
    }
};

} // namespace

ControlDesk::ControlDesk(QList<SensorStation*> stations)
    : m_stations(std::move(stations))
{}

QByteArray ControlDesk::answer(const QByteArray& line)
{
    Done done = carryOut(line);
    if (!done)
        return errorLine(done.error());
    done->insert(u"ok"_s, true);
    return jsonLine(*done);
}

QByteArray ControlDesk::answerToOverlongLine()
{
    return errorLine(u"a line of more than %1 bytes; nothing of it was done"_s.arg(longestLine));
}

ControlDesk::Done ControlDesk::carryOut(const QByteArray& line)
{
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString text = decoder(line);
    if (decoder.hasError() || text.contains(QChar(u'\0')))
        return tl::unexpected(u"the line is no text"_s);
    const auto command = parseControlLine(text);
    if (!command)
        return tl::unexpected(command.error());
    if (std::holds_alternative<ControlCommand::Help>(command->what))
        return QJsonObject{{u"commands"_s, QJsonArray::fromStringList(controlForms())}};
    const bool wantsStatus = std::holds_alternative<ControlCommand::Status>(command->what);
    if (wantsStatus && !command->sensor && m_stations.size() != 1) {
        QJsonArray sensors;
        for (int i = 0; i < m_stations.size(); ++i)
            sensors.append(describe(i));
        return QJsonObject{{u"sensors"_s, sensors}};
    }
    const auto index = indexOf(*command);
    if (!index)
        return tl::unexpected(index.error());
    if (const auto done = std::visit(CarryOut{*m_stations.at(*index)}, command->what); !done)
        return tl::unexpected(done.error());
    return describe(*index);
}

tl::expected<int, QString> ControlDesk::indexOf(const ControlCommand& command) const
{
    const auto count = int(m_stations.size());
    if (!command.sensor && count == 1)
        return 0;
    if (!command.sensor)
        return tl::unexpected(u"there are %1 sensors; begin with \"sensor N\", N from 1 to %1"_s.arg(count));
    if (*command.sensor < 1 || *command.sensor > count)
        return tl::unexpected(u"there is no sensor %1; there are 1 to %2"_s.arg(*command.sensor).arg(count));
    return *command.sensor - 1;
}

QJsonObject ControlDesk::describe(int index)
{
    SensorStation& station = *m_stations.at(index);
    station.player().follow();
    station.sensor().catchUp();
    const StationState state = station.state();
    const auto& model = catalog::Catalog::hlG2().model(station.sensor().model());
    return {{u"sensor"_s, index + 1},
            {u"type"_s, QString::fromLatin1(model.typeName)},
            {u"scene"_s, state.scene.isEmpty() ? u"gentle"_s : state.scene},
            {u"workpieces"_s, QJsonArray::fromStringList(state.workpieces)},
            {u"workpiece"_s, workpieceText(state)},
            {u"faults"_s, faultsThatAreOn(state)},
            {u"trigger"_s, state.triggerByPerson || state.triggerByScene},
            {u"ready"_s, station.sensor().isReady()},
            {u"measuredValue"_s, station.sensor().read(catalog::ItemId::MeasuredValue)},
            {u"modbusPort"_s, portValue(station.modbusPort())},
            {u"toolPort"_s, portValue(station.toolPort())}};
}

} // namespace lds::app
