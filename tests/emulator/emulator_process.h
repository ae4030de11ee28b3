#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QStringList>

namespace lds::test {

/// The built lds-emulator (LDS_BIN) as a process of its own, waited for until it says that it is ready.
/// Ended with the object.
class EmulatorProcess {
public:
    explicit EmulatorProcess(const QStringList& arguments);
    ~EmulatorProcess();

    static QString program();
    /// What it printed; an empty line when it did not get ready.
    const QByteArray& line() const { return m_line; }
    QJsonObject ready() const;
    quint16 modbusPort() const { return port(ready(), QLatin1StringView("modbusPort")); }
    static quint16 port(const QJsonObject& ready, QLatin1StringView key);
    qint64 processId() const { return m_process.processId(); }
    /// The line with which it answers a control line; empty when none comes.
    QByteArray control(const QByteArray& line);
    void closeInput() { m_process.closeWriteChannel(); }
    QByteArray errors() { return m_process.readAllStandardError(); }
    /// Exit code after a signal; −1 when it did not end properly.
    int endWith(int signal);

private:
    QProcess m_process;
    QByteArray m_line;
};

} // namespace lds::test
