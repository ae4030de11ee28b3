#include "control_language.h"

#include "fault_desk.h"

#include <QRegularExpression>

namespace lds::app {

using namespace Qt::StringLiterals;
using emulator::FaultDesk;
using emulator::NamedFault;

namespace {

using What = tl::expected<ControlCommand::What, QString>;

constexpr qsizetype longestQuotation = 60;

/// Somebody else's text inside a message: short, whatever it is.
QString quoted(const QString& text)
{
    return text.size() > longestQuotation ? u"\"%1…\""_s.arg(text.left(longestQuotation))
                                          : u"\"%1\""_s.arg(text);
}

/// Takes the first word off.
QString takeWord(QString& rest)
{
    const qsizetype end = rest.indexOf(u' ');
    const QString word = end < 0 ? rest : rest.left(end);
    rest = end < 0 ? QString() : rest.mid(end + 1).trimmed();
    return word;
}

std::optional<bool> onOrOff(const QString& word)
{
    if (word == "on"_L1)
        return true;
    if (word == "off"_L1)
        return false;
    return std::nullopt;
}

QString faultNames()
{
    QStringList names;
    for (const NamedFault fault : emulator::allFaults())
        names.append(keyOf(fault));
    return names.join(u", "_s);
}

What parseScene(const QString& rest)
{
    if (rest.isEmpty())
        return tl::unexpected(u"scene: which one? scene NAME, scene FILE, or scene gentle"_s);
    return ControlCommand::Scene{rest == "gentle"_L1 ? QString() : rest};
}

/// Millimetres with up to four decimals, exactly.
std::optional<catalog::Value> placeOf(const QString& text)
{
    static const QRegularExpression form(u"^([+-]?)(\\d{1,3})(?:\\.(\\d{1,4}))?$"_s);
    const auto match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    const int whole = match.captured(2).toInt();
    const int fraction = match.captured(3).leftJustified(4, u'0').toInt();
    const catalog::Value value = whole * 10'000 + fraction;
    return match.captured(1) == "-"_L1 ? -value : value;
}

What parseWorkpiece(const QString& rest)
{
    if (rest.isEmpty())
        return tl::unexpected(
            u"workpiece: which one? workpiece NAME, workpiece at MM, or workpiece moving"_s);
    if (rest == "moving"_L1)
        return ControlCommand::LetMove{};
    if (!rest.startsWith("at "_L1))
        return ControlCommand::HoldWorkpiece{rest};
    const auto place = placeOf(rest.mid(3).trimmed());
    if (!place)
        return tl::unexpected(
            u"workpiece at: %1 is no distance; give millimetres from the measurement centre, -999.9999 to 999.9999"_s
                .arg(quoted(rest.mid(3).trimmed())));
    return ControlCommand::HoldAt{*place};
}

What parseFault(QString rest)
{
    const QString name = takeWord(rest);
    const auto fault = emulator::faultNamed(name);
    if (!fault)
        return tl::unexpected(u"fault: %1 is no fault; there are: %2"_s.arg(quoted(name), faultNames()));
    const QString word = takeWord(rest);
    const auto on = onOrOff(word);
    if (!on)
        return tl::unexpected(u"fault %1: on or off, not %2"_s.arg(name, quoted(word)));
    if (rest.isEmpty())
        return ControlCommand::Fault{*fault, *on, std::nullopt};
    if (!*on || !defaultMilliseconds(*fault))
        return tl::unexpected(u"fault %1 %2 takes nothing more, not %3"_s.arg(name, word, quoted(rest)));
    bool isNumber = false;
    const int milliseconds = rest.toInt(&isNumber);
    if (!isNumber || milliseconds < 1 || milliseconds > FaultDesk::longestMs)
        return tl::unexpected(u"fault %1 on: milliseconds from 1 to %2, not %3"_s.arg(name)
                                  .arg(FaultDesk::longestMs)
                                  .arg(quoted(rest)));
    return ControlCommand::Fault{*fault, true, milliseconds};
}

What parseTrigger(const QString& rest)
{
    const auto on = onOrOff(rest);
    if (!on)
        return tl::unexpected(u"trigger: on or off, not %1"_s.arg(quoted(rest)));
    return ControlCommand::Trigger{*on};
}

What parseWhat(const QString& verb, const QString& rest)
{
    if (verb == "scene"_L1)
        return parseScene(rest);
    if (verb == "workpiece"_L1)
        return parseWorkpiece(rest);
    if (verb == "fault"_L1)
        return parseFault(rest);
    if (verb == "trigger"_L1)
        return parseTrigger(rest);
    if (verb == "power"_L1 && rest == "cycle"_L1)
        return ControlCommand::PowerCycle{};
    if (verb == "power"_L1)
        return tl::unexpected(u"power: cycle, not %1"_s.arg(quoted(rest)));
    if (verb == "status"_L1 && rest.isEmpty())
        return ControlCommand::Status{};
    if (verb == "help"_L1 && rest.isEmpty())
        return ControlCommand::Help{};
    if (verb == "status"_L1 || verb == "help"_L1)
        return tl::unexpected(u"%1 takes nothing more, not %2"_s.arg(verb, quoted(rest)));
    return tl::unexpected(
        u"%1 is no command; these are: scene, workpiece, fault, trigger, power cycle, status, help"_s.arg(
            quoted(verb)));
}

} // namespace

tl::expected<ControlCommand, QString> parseControlLine(const QString& line)
{
    QString rest = line.trimmed();
    if (rest.isEmpty())
        return tl::unexpected(u"an empty line; try help"_s);
    std::optional<int> sensor;
    QString verb = takeWord(rest);
    if (verb == "sensor"_L1) {
        const QString number = takeWord(rest);
        bool isNumber = false;
        sensor = number.toInt(&isNumber);
        if (!isNumber)
            return tl::unexpected(u"sensor: %1 is no number"_s.arg(quoted(number)));
        verb = takeWord(rest);
        if (verb.isEmpty())
            return tl::unexpected(u"sensor %1: what with it? Try help"_s.arg(*sensor));
    }
    return parseWhat(verb, rest).map([sensor](const ControlCommand::What& what) {
        return ControlCommand{sensor, what};
    });
}

QStringList controlForms()
{
    return {u"scene NAME | scene FILE | scene gentle"_s,
            u"workpiece NAME | workpiece at MM | workpiece moving"_s,
            u"fault NAME on [MILLISECONDS] | fault NAME off"_s,
            u"trigger on | trigger off"_s,
            u"power cycle"_s,
            u"status"_s,
            u"help"_s,
            u"sensor N ..."_s};
}

} // namespace lds::app
