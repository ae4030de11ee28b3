#include "session_fixture.h"

#include <QRandomGenerator>

using namespace lds::sensor;
using lds::ports::FailureCode;
using lds::ports::OpenFailure;
using lds::ports::Request;
using lds::ports::RequestKind;
using lds::support::FakeSensor;
using lds::support::settle;

namespace {

const QList<ItemId> someSettings{
    ItemId::Span,         ItemId::Offset,          ItemId::HighSetValue,      ItemId::LowSetValue,
    ItemId::Hysteresis,   ItemId::Tolerance,       ItemId::HoldMode,          ItemId::TriggerMode,
    ItemId::DisplayDigit, ItemId::AlarmDelayCount, ItemId::IpAddress4thOctet, ItemId::DefaultGateway4thOctet,
    ItemId::PortModbus,   ItemId::PortTool,        ItemId::DisplayInversion,  ItemId::AverageTimes};
const QList<ItemId> someCommands{ItemId::SetValueSaving, ItemId::LaserStop,
                                 ItemId::KeyLock,        ItemId::ZeroSetting,
                                 ItemId::BankSwitching,  ItemId::SettingsInitialization};

} // namespace

/// Everything at once and in any order: people, PLCs, lost answers, cuts. Whatever happens, each apply and
/// each command ends exactly once, no write is repeated, and at the end what is held is what the sensor has.
class SessionStormTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whateverHappensEverythingEndsOnceAndNothingIsWrittenTwice_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 40; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void whateverHappensEverythingEndsOnceAndNothingIsWrittenTwice()
    {
        QFETCH(quint32, seed);
        m_random = QRandomGenerator(seed);
        SessionFixture f;
        m_appliesStarted = m_commandsStarted = 0;
        f.sensor().setOnRequest([this, &f](const Request& request) { countWrite(f, request); });
        f.session->open();
        settle();
        for (int step = 0; step < 300; ++step) {
            somethingHappens(f);
            if (m_random.bounded(3) == 0)
                settle();
            if (m_random.bounded(4) == 0)
                f.pass(int(m_random.bounded(1, 60)) * 10);
            QVERIFY(f.applies.size() <= m_appliesStarted);
            QVERIFY(m_appliesStarted - f.applies.size() <= 1);
            QVERIFY(m_commandsStarted - f.commands.size() <= 1);
        }
        calmDown(f);
        QCOMPARE(f.applies.size(), m_appliesStarted);
        QCOMPARE(f.commands.size(), m_commandsStarted);
        QVERIFY(f.session->isReady());
        QVERIFY(f.session->canWrite());
        for (const ItemId item : someSettings + QList{ItemId::BankSwitching, ItemId::LaserStop})
            QCOMPARE(f.session->held(item), std::optional(f.sensor().value(item)));
        QVERIFY(!m_repeated);
    }

private:
    int any(int below) { return int(m_random.bounded(below)); }
    ItemId anySetting() { return someSettings.at(any(int(someSettings.size()))); }
    ItemId anyCommand() { return someCommands.at(any(int(someCommands.size()))); }

    /// The same value to the same item within one run, unless something else was written to it between.
    void countWrite(SessionFixture& f, const Request& request)
    {
        if (request.kind != RequestKind::Write)
            return;
        const int run = int(m_appliesStarted + m_commandsStarted);
        if (std::exchange(m_run, run) != run || !f.session->isApplying())
            m_lastWritten.clear();
        const auto key = request.write.first().item;
        m_repeated = m_repeated || (m_lastWritten.contains(key) && m_lastWritten.value(key) == request.write);
        m_lastWritten.insert(key, request.write);
    }

    Value anyValue(SessionFixture& f, ItemId id)
    {
        const auto& item = lds::catalog::hlG2(id);
        if (!item.choices.empty())
            return item.choices[std::size_t(any(int(item.choices.size())))].code;
        const auto& limits = item.limitsFor(f.session->model());
        const Value near = f.sensor().value(id) + (any(2000) - 1000) * limits.resolution;
        return std::clamp(near, limits.minimum, limits.maximum);
    }

    void somethingHappens(SessionFixture& f)
    {
        switch (any(22)) {
        case 0:
        case 1:
        case 2:
        case 3: {
            const ItemId item = anySetting();
            f.edit(item, anyValue(f, item));
            break;
        }
        case 4:
            f.session->undo();
            break;
        case 5:
            f.session->redo();
            break;
        case 6:
            f.session->revert({anySetting()});
            break;
        case 7:
            f.session->keepMine(anySetting());
            break;
        case 8:
        case 9:
        case 10:
            m_appliesStarted += f.session->apply() ? 1 : 0;
            break;
        case 11:
        case 12: {
            const ItemId item = anyCommand();
            m_commandsStarted += f.session->run(item, anyValue(f, item)) ? 1 : 0;
            break;
        }
        case 13:
            f.session->cancelApply();
            break;
        case 14: {
            const ItemId item = anySetting();
            const auto next =
                lds::settings::apply(f.session->model(), f.sensor().values(), {{item, anyValue(f, item)}});
            if (next && f.sensor().value(item) != next->value(item))
                f.sensor().set(item, next->value(item)); // a PLC
            break;
        }
        case 15:
            f.sensor().switchBank(1 + any(4));
            break;
        case 16:
            f.sensor().loseAnswer(any(2) ? anySetting() : anyCommand(),
                                  any(2) ? FakeSensor::Carried::Out : FakeSensor::Carried::Not);
            break;
        case 17:
            f.sensor().loseReads(any(3));
            break;
        case 18:
            f.sensor().timeOut();
            break;
        case 19:
            if (any(3) == 0)
                f.sensor().cut();
            break;
        case 20:
            f.sensor().setNotReady(any(2) == 0);
            break;
        default:
            if (any(4) == 0)
                f.session->close();
            else
                f.session->open();
            break;
        }
    }

    void calmDown(SessionFixture& f)
    {
        f.sensor().setNotReady(false);
        f.sensor().loseReads(0);
        f.session->open();
        for (int i = 0; i < 20; ++i) {
            settle();
            f.sensor().timeOut();
            settle();
            f.pass(2000);
        }
        f.session->readAll();
        settle();
    }

    QRandomGenerator m_random;
    qsizetype m_appliesStarted = 0;
    qsizetype m_commandsStarted = 0;
    int m_run = -1;
    QMap<ItemId, lds::settings::Write> m_lastWritten;
    bool m_repeated = false;
};

QTEST_GUILESS_MAIN(SessionStormTest)
#include "tst_session_storm.moc"
