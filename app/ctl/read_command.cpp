#include "read_command.h"

#include "console.h"
#include "texts.h"
#include "value_report.h"

namespace lds::ctl {

bool ReadCommand::prepare()
{
    for (const QString& key : line().arguments) {
        if (!addTarget(key)) {
            finish(ExitCode::Usage);
            return false;
        }
    }
    return true;
}

bool ReadCommand::addTarget(const QString& key)
{
    const std::optional<Target> target = findTarget(key);
    if (!target) {
        console().message(unknownKeyMessage(key));
        return false;
    }
    const auto& item = catalog::hlG2(target->items.first());
    if (!item.isReadable()) {
        console().message(
            item.isWritable()
                ? Texts::tr(
                      "%1 has no value to read: writing it carries something out. See “ldsctl catalog”.")
                      .arg(key)
                : Texts::tr(
                      "%1 cannot be read: no protocol has an address for it. Look at the sensor, menu %2.")
                      .arg(key)
                      .arg(item.menu));
        return false;
    }
    m_targets.append(*target);
    return true;
}

void ReadCommand::addEverything()
{
    for (const auto& item : session().catalog().items()) {
        if (item.isReadable() && session().reaches(item.id))
            m_targets.append({QString::fromLatin1(item.key), {item.id}});
    }
}

void ReadCommand::onReady()
{
    if (m_targets.isEmpty())
        addEverything();
    QList<Target> known;
    ExitCode code = ExitCode::Done;
    for (const Target& target : m_targets) {
        if (!valueWords(target, session().model(), session().heldValues()).isEmpty()) {
            known += target;
            continue;
        }
        console().message(Texts::tr("%1: the sensor did not give it over this connection.").arg(target.key));
        code = ExitCode::Refused;
    }
    report(known);
    finish(code);
}

void ReadCommand::report(const QList<Target>& known)
{
    const auto model = session().model();
    const auto& values = session().heldValues();
    if (line().json) {
        QJsonObject object;
        for (const Target& target : known)
            object.insert(target.key, valueJson(target, model, values));
        console().json(object);
        return;
    }
    QList<QStringList> rows;
    for (const Target& target : known)
        rows += QStringList{target.key, valueWords(target, model, values), unitOf(target, values)};
    const QStringList lines = alignedLines(rows);
    for (const QString& text : lines)
        console().line(text);
}

} // namespace lds::ctl
