#pragma once

#include "console.h"
#include "fake_link.h"
#include "info_command.h"
#include "manual_scheduler.h"
#include "monitor_command.h"
#include "read_command.h"
#include "set_command.h"

#include <QBuffer>
#include <QJsonDocument>
#include <QTest>

namespace lds::ctl {

using namespace Qt::StringLiterals;
using catalog::ItemId;
using support::FakeSensor;
using support::settle;

/// One ldsctl with a sensor in memory and a clock that only the test moves.
class Ctl {
public:
    explicit Ctl(const QStringList& arguments, const QString& parameters = u"?sensor=HL-G203B-S-MK"_s)
    {
        ports::registerMetaTypes();
        output.open(QIODevice::WriteOnly);
        errors.open(QIODevice::WriteOnly);
        const auto parsed = parseCommandLine(
            QStringList{u"ldsctl"_s, u"-c"_s, u"modbus-tcp://127.0.0.1:502"_s + parameters} + arguments);
        if (!parsed)
            qFatal("%s", qPrintable(parsed.error().message));
        const auto line = std::get<CommandLine>(*parsed);
        url = *line.url;
        session = std::make_unique<sensor::SensorSession>(url, links, scheduler);
        command = make(line);
        QObject::connect(command.get(), &SessionCommand::finished, command.get(), [this](ExitCode code) {
            ++finishes;
            exitCode = int(code);
        });
    }
    ~Ctl()
    {
        command.reset();
        session.reset();
        settle();
    }

    FakeSensor& sensor() { return links.sensor(url); }
    Ctl& start()
    {
        command->start();
        settle();
        return *this;
    }
    void pass(int ms)
    {
        for (int gone = 0; gone < ms; gone += 10) {
            scheduler.advanceMs(10);
            settle();
        }
    }
    QString out() const { return QString::fromUtf8(output.data()); }
    QString err() const { return QString::fromUtf8(errors.data()); }
    QJsonObject json() const { return QJsonDocument::fromJson(output.data()).object(); }
    QStringList statuses() const
    {
        QStringList words;
        const QJsonArray results = json().value(u"results"_s).toArray();
        for (const auto& result : results)
            words += result.toObject().value(u"key"_s).toString() + u' ' +
                     result.toObject().value(u"status"_s).toString();
        return words;
    }

    ports::ManualScheduler scheduler;
    support::FakeLinkFactory links{scheduler};
    ports::ConnectionUrl url;
    QBuffer output;
    QBuffer errors;
    Console console{output, errors};
    std::unique_ptr<sensor::SensorSession> session;
    std::unique_ptr<SessionCommand> command;
    int finishes = 0;
    int exitCode = -1;

private:
    std::unique_ptr<SessionCommand> make(const CommandLine& line)
    {
        switch (line.verb) {
        case Verb::Info:
            return std::make_unique<InfoCommand>(line, *session, scheduler, console);
        case Verb::Read:
            return std::make_unique<ReadCommand>(line, *session, scheduler, console);
        case Verb::Set:
            return std::make_unique<SetCommand>(line, *session, scheduler, console);
        default:
            return std::make_unique<MonitorCommand>(line, *session, scheduler, console);
        }
    }
};

} // namespace lds::ctl

#define VERIFY_ENDED(ctl, code)                                                                              \
    QCOMPARE((ctl).finishes, 1);                                                                             \
    QVERIFY2((ctl).exitCode == (code), qPrintable((ctl).err()))
