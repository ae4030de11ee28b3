// A line in real time, from a program's end of it.
#include "line_fixture.h"
#include "rtu_port.h"
#include "serial_client.h"
#include "system_clock.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;
using namespace Qt::StringLiterals;

class RtuPortTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

    void answersAProgram();
    void theProgramsSettingsCountAndNoOthers();
    void aRequestInSmallPiecesIsARequest();
    void noAnswerIsFasterThanTheLine();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SystemClock> m_clock;
    std::unique_ptr<RtuPort> m_port;
    std::unique_ptr<VirtualSensor> m_sensor;
    std::unique_ptr<RtuUnit> m_unit;
};

void RtuPortTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_clock = std::make_unique<SystemClock>();
    auto port = RtuPort::open(m_folder->filePath(u"line"_s), *m_clock);
    QVERIFY2(port.has_value(), port ? "" : qPrintable(port.error()));
    m_port = std::move(*port);
    m_sensor = std::make_unique<VirtualSensor>(SensorModel::HlG203, *m_clock);
    m_unit = std::make_unique<RtuUnit>(*m_sensor);
    m_port->line().attach(*m_unit);
}

void RtuPortTest::cleanup()
{
    m_unit.reset();
    m_sensor.reset();
    m_port.reset();
    m_clock.reset();
}

void RtuPortTest::answersAProgram()
{
    SerialClient client(m_port->link());
    client.configure(B38400, LineParity::Even);
    client.send(readSpan(1));
    QByteArray taken;
    QTRY_COMPARE(taken += client.take(), spanAnswer(1));
}

void RtuPortTest::theProgramsSettingsCountAndNoOthers()
{
    SerialClient client(m_port->link());
    int noise = 0;
    for (const auto& [speed, parity] :
         {std::pair{B9600, LineParity::Even}, std::pair{B38400, LineParity::Odd},
          std::pair{B38400, LineParity::None}}) {
        client.configure(speed, parity);
        client.send(readSpan(1));
        ++noise;
        QTRY_COMPARE(m_port->line().frameCount(), noise);
    }
    QCOMPARE(m_unit->totalRequestCount(), 0);
    client.configure(B38400, LineParity::Even);
    client.send(readSpan(1));
    QByteArray taken;
    QTRY_COMPARE(taken += client.take(), spanAnswer(1));
}

void RtuPortTest::aRequestInSmallPiecesIsARequest()
{
    SerialClient client(m_port->link());
    client.configure(B38400, LineParity::Even);
    const QByteArray request = readSpan(1);
    const RtuLine& line = m_port->line();
    // A busy machine may pause between two pieces for longer than a message may: then it is noise, rightly.
    for (int attempt = 0; attempt < 20 && line.frameCount() == 0; ++attempt) {
        const int before = line.noiseCount();
        for (const char byte : request)
            client.send(QByteArray(1, byte));
        QTRY_VERIFY(line.frameCount() > 0 || line.noiseCount() > before);
    }
    QByteArray taken;
    QTRY_COMPARE(taken += client.take(), spanAnswer(1));
}

void RtuPortTest::noAnswerIsFasterThanTheLine()
{
    SerialClient client(m_port->link());
    client.configure(B38400, LineParity::Even);
    for (int time = 0; time < 20; ++time) {
        QElapsedTimer timer;
        timer.start();
        client.send(readSpan(1));
        QByteArray taken;
        while (taken.size() < spanAnswer(1).size() && timer.elapsed() < 5000) {
            QCoreApplication::processEvents();
            taken += client.take();
        }
        QCOMPARE(taken, spanAnswer(1));
        QVERIFY(timer.nsecsElapsed() >= 2'291'667 + 1'750'000 + 2'578'125);
    }
}

QTEST_GUILESS_MAIN(RtuPortTest)
#include "tst_rtu_port.moc"
