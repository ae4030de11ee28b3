#pragma once

#include <functional>
#include <memory>
#include <QByteArray>
#include <QList>
#include <QMap>
#include <QObject>
#include <QQueue>
#include <QSet>
#include <QSocketNotifier>
#include <QString>

namespace lds::tests {

/// A serial line on a pseudo-terminal whose units do what a test tells them, byte by byte. It knows nothing
/// of the product's codec: its bytes and its CRC are made by hand, so that a misreading does not agree with
/// itself.
class ScriptedLine final : public QObject {
    Q_OBJECT

public:
    struct Received {
        quint8 unit = 0;
        QByteArray pdu;
        int function() const { return quint8(pdu.at(0)); }
        int word(int index) const { return quint8(pdu.at(index)) << 8 | quint8(pdu.at(index + 1)); }
        int first() const { return 400001 + word(1); } ///< As the manual prints it.
        int count() const { return word(3); }
        bool isWrite() const { return function() == 0x06 || function() == 0x10; }
        bool isCoils() const { return function() == 0x01; }
    };
    using Script = std::function<void(const Received&)>;

    ScriptedLine();
    ~ScriptedLine() override;

    QString port() const { return m_port; }
    void unplug(); ///< The port is gone for whoever has it open.

    QSet<int> units{1};
    /// Of every unit, by printed number; the others read as 1000 · unit. A start: Span 1.0000.
    QMap<int, quint16> registers{{400116, 10000}, {400117, 0}};

    void next(const Script& script) { m_scripts.enqueue(script); } ///< For the next request of data.
    void nextCoils(const Script& script) { m_coilScripts.enqueue(script); }
    void always(const Script& script) { m_always = script; } ///< For all requests beyond those, coils too.
    void answerWell() { m_always = {}; }

    QByteArray goodPdu(const Received& request); ///< And does what a write asks.
    QByteArray goodFrame(const Received& request);
    static QByteArray frame(quint8 unit, const QByteArray& pdu);
    void send(const QByteArray& bytes);
    /// A sensor that is slow: what is sent from now on goes out, in its order, when the time is over.
    void hold(int ms);

    QList<Received> received; ///< With a good CRC.
    QList<Received> data() const;
    int writes() const;

private:
    void onReadable();
    bool takeRequest();
    void handle(const Received& request);

    int m_master = -1;
    QString m_port;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_buffer;
    bool m_holding = false;
    QList<QByteArray> m_held;
    QQueue<Script> m_scripts;
    QQueue<Script> m_coilScripts;
    Script m_always;
};

inline const ScriptedLine::Script lineSilence = [](const ScriptedLine::Received&) {};

} // namespace lds::tests
