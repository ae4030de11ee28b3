#include "serial_texts.h"

#include "catalog.h"
#include "item_text.h"
#include "sentences.h"
#include "serial_choices.h"

#include <QComboBox>
#include <QCoreApplication>
#include <set>

namespace lds::ui {

using catalog::ItemId;
using procedures::ChangeProblem;
using procedures::CommunicationChange;

namespace {

struct SerialTexts {
    Q_DECLARE_TR_FUNCTIONS(SerialTexts)
};

QString choiceText(ItemId item, catalog::Value code)
{
    return displayValue(catalog::hlG2(item), catalog::SensorModel::HlG203, code); // same for all types
}

QString problemSentence(const procedures::ChangeFailure& failure, const ports::ConnectionUrl& wanted)
{
    const auto* item = failure.item ? &catalog::hlG2(*failure.item) : nullptr;
    const QString wire = failureSentence(failure.wire, item);
    switch (failure.problem) {
    case ChangeProblem::WriteFailed:
        if (failure.wire.code != ports::FailureCode::None)
            return SerialTexts::tr("Not every setting could be written. %1").arg(wire);
        return SerialTexts::tr("Not every setting could be written: %1 reads back as another value.")
            .arg(item ? itemName(*item) : QString());
    case ChangeProblem::SaveFailed:
        return SerialTexts::tr("The settings were written but not saved. %1").arg(wire);
    case ChangeProblem::SaveUnknown:
        return SerialTexts::tr("The sensor did not answer to saving, so it is not known whether its memory "
                               "has the new settings. Nothing was reset.");
    case ChangeProblem::ResetFailed:
        return SerialTexts::tr("The new settings are saved, but the sensor did not carry out the "
                               "communication reset. They count from the next time its power is switched "
                               "on. %1")
            .arg(wire);
    case ChangeProblem::StillOld:
        return SerialTexts::tr("The new settings are saved, but the sensor still speaks with the former "
                               "ones. Switch its power off and on to make the new ones count, or go back.");
    case ChangeProblem::NoAnswer: {
        const QString sentence = SerialTexts::tr(
            "After the reset the sensor answers neither with the new settings nor with the "
            "former ones. Switch its power off and on; it is looked for with the new settings "
            "all the while.");
        const bool isSilent = failure.line.failure == ports::OpenFailure::NoAnswer;
        return isSilent ? sentence : sentence + u' ' + openFailureSentence(failure.line, wanted);
    }
    case ChangeProblem::OtherValues:
        return SerialTexts::tr(
            "What answers with the new settings holds others. It may be another sensor, or "
            "somebody has changed it at its keys. Read all and compare.");
    case ChangeProblem::PortFailed:
        return SerialTexts::tr("It could not be asked whether the new address is free, so nothing was "
                               "written. %1")
            .arg(openFailureSentence(failure.line, wanted));
    case ChangeProblem::Cancelled:
        return SerialTexts::tr("Stopped before anything was written.");
    case ChangeProblem::Disconnected:
        return SerialTexts::tr("The connection ended on the way. When it is back, read all to see what the "
                               "sensor holds.");
    case ChangeProblem::None:
    case ChangeProblem::NothingToChange:
    case ChangeProblem::NotPossibleNow:
    case ChangeProblem::OthersOnLine:
    case ChangeProblem::AddressInList:
    case ChangeProblem::AddressAnswers:
        return obstacleSentence(failure.problem, wanted.unit);
    }
    return {};
}

} // namespace

QString speedText(int baud)
{
    const auto code = ports::speedCode(baud);
    return code ? choiceText(ItemId::CommunicationSpeed, *code) : SerialTexts::tr("%1 bps").arg(baud);
}

QString parityText(ports::SerialParity parity)
{
    return choiceText(ItemId::ParityStopBit, ports::parityCode(parity));
}

QString serialText(const ports::SerialSettings& serial)
{
    return SerialTexts::tr("%1, %2").arg(speedText(serial.baud), parityText(serial.parity));
}

void fillSpeeds(QComboBox* box)
{
    for (const int speed : ports::serialSpeeds())
        box->addItem(speedText(speed), speed);
}

void fillParities(QComboBox* box)
{
    using ports::SerialParity;
    for (const SerialParity parity : {SerialParity::None, SerialParity::Even, SerialParity::Odd})
        box->addItem(parityText(parity), int(parity));
}

void showSerial(const ports::SerialSettings& serial, QComboBox* speeds, QComboBox* parities)
{
    speeds->setCurrentIndex(qMax(0, speeds->findData(serial.baud)));
    parities->setCurrentIndex(qMax(0, parities->findData(int(serial.parity))));
}

ports::SerialSettings serialOf(const QComboBox* speeds, const QComboBox* parities)
{
    return {speeds->currentData().toInt(), ports::SerialParity(parities->currentData().toInt())};
}

std::optional<QList<quint8>> parseUnits(const QString& text)
{
    constexpr int most = 247;
    const auto number = [](const QString& part) -> int {
        bool isNumber = false;
        const uint value = part.trimmed().toUInt(&isNumber);
        return isNumber && value >= 1 && value <= most ? int(value) : 0;
    };
    std::set<quint8> units;
    QString plain = text;
    plain.replace(QChar(0x2013), u'-'); // an en dash, as texts are pasted
    for (const QString& part : plain.split(u',')) {
        const QStringList ends = part.split(u'-');
        const int first = number(ends.first());
        const int last = number(ends.last());
        if (ends.size() > 2 || first == 0 || last < first)
            return std::nullopt;
        for (int unit = first; unit <= last; ++unit)
            units.insert(quint8(unit));
    }
    return QList<quint8>(units.begin(), units.end());
}

QString findingWord(const ports::ScanFinding& finding)
{
    using Kind = ports::ScanFinding::Kind;
    switch (finding.kind) {
    case Kind::Sensor:
        return SerialTexts::tr("HL-G2 sensor");
    case Kind::OtherDevice:
        return SerialTexts::tr("Another device");
    case Kind::TwoUnits:
        return SerialTexts::tr("Two units answer");
    case Kind::Noise:
        return SerialTexts::tr("Noise");
    }
    return {};
}

QString findingAdvice(const ports::ScanFinding& finding)
{
    using Kind = ports::ScanFinding::Kind;
    switch (finding.kind) {
    case Kind::Sensor:
        return {};
    case Kind::OtherDevice:
        return SerialTexts::tr("Answers by Modbus, but not as an HL-G2 does.");
    case Kind::TwoUnits:
        return SerialTexts::tr(
            "Two units with this address talk at the same time. Disconnect one of them, or "
            "give it another address with its keys (menu 82), and scan again.");
    case Kind::Noise:
        return SerialTexts::tr("Bytes come that answer nobody: somebody else speaks on this line, or it is "
                               "disturbed. Stop other programs and controllers on it, check wiring, shield "
                               "and termination (menu 81), and scan again.");
    }
    return {};
}

QString obstacleSentence(ChangeProblem problem, quint8 unit)
{
    switch (problem) {
    case ChangeProblem::NothingToChange:
        return SerialTexts::tr("These are the settings the sensor has.");
    case ChangeProblem::NotPossibleNow:
        return SerialTexts::tr(
            "The sensor cannot be changed now. Wait until it is connected and what is under "
            "way has ended.");
    case ChangeProblem::OthersOnLine:
        return SerialTexts::tr(
            "Other sensors on this port are connected with the present speed and parity, and a "
            "port has one at a time. Disconnect them first, then change them one by one.");
    case ChangeProblem::AddressInList:
        return SerialTexts::tr("Another sensor of the list has address %1 on this port. Choose another.")
            .arg(unit);
    case ChangeProblem::AddressAnswers:
        return SerialTexts::tr(
                   "Something on this line answers to address %1 already, so nothing was written. "
                   "Choose another.")
            .arg(unit);
    default:
        return {};
    }
}

QString changeSentence(const CommunicationChange& change)
{
    using State = CommunicationChange::State;
    const auto now = [&change] {
        if (!change.sensorAt())
            return QString();
        return SerialTexts::tr("The sensor answers at address %1 with %2.")
            .arg(change.sensorAt()->unit)
            .arg(serialText(change.sensorAt()->serial));
    };
    switch (change.state()) {
    case State::Done:
        return SerialTexts::tr("Done. %1").arg(now());
    case State::WentBack:
        return SerialTexts::tr("The former settings are back. %1").arg(now());
    case State::Failed: {
        const QString why = problemSentence(change.failure(), change.newUrl());
        return change.sensorAt() ? why + u' ' + now() : why;
    }
    default:
        return {};
    }
}

QString changeStepText(CommunicationChange::State step)
{
    using State = CommunicationChange::State;
    switch (step) {
    case State::Checking:
        return SerialTexts::tr("Ask whether the new address is free");
    case State::Writing:
        return SerialTexts::tr("Write the settings and read them back");
    case State::Saving:
        return SerialTexts::tr("Save in the sensor");
    case State::Resetting:
        return SerialTexts::tr("Reset communication");
    case State::Reopening:
        return SerialTexts::tr("Connect with the settings that count now");
    case State::Verifying:
        return SerialTexts::tr("Read back and compare");
    default:
        return {};
    }
}

} // namespace lds::ui
