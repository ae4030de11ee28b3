#include "demo_sensor.h"

#include <QSignalSpy>
#include <QTcpSocket>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;

class DemoSensorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void tellsItsPortAndServesThere();
    void hooksRunInItsThread();
    void mayEndAtAnyTime();
};

void DemoSensorTest::tellsItsPortAndServesThere()
{
    DemoSensor demo(SensorModel::HlG225);
    QSignalSpy ready(&demo, &DemoSensor::ready);
    demo.start();
    demo.start(); // once is enough
    QTRY_COMPARE(ready.size(), 1);
    QCOMPARE(demo.port(), ready.first().first().value<quint16>());
    QTcpSocket client;
    client.connectToHost(QHostAddress::LocalHost, demo.port());
    QVERIFY(client.waitForConnected());
    client.write(QByteArray::fromHex("0001 0000 0006 01 03 0064 0002"));
    QVERIFY(client.waitForReadyRead());
    QCOMPARE(client.readAll(), QByteArray::fromHex("0001 0000 0007 01 03 04 e360 0016")); // 1,500,000
    QCOMPARE(demo.ask([](SensorStation& station) { return station.modbusServer().requestCount(3); }), 1);
}

void DemoSensorTest::hooksRunInItsThread()
{
    DemoSensor demo(SensorModel::HlG203);
    demo.post([](SensorStation&) {}); // dropped
    QSignalSpy ready(&demo, &DemoSensor::ready);
    demo.start();
    QVERIFY(ready.wait());
    demo.post([](SensorStation& station) { station.sensor().changeByKeypad(ItemId::Offset, 321); });
    const Value offset = demo.ask([](SensorStation& station) {
        station.sensor().catchUp();
        return station.sensor().read(ItemId::Offset);
    });
    QCOMPARE(offset, 321);
    QVERIFY(demo.ask([](SensorStation&) { return QThread::currentThread(); }) != QThread::currentThread());
}

void DemoSensorTest::mayEndAtAnyTime()
{
    for (int round = 0; round < 20; ++round) {
        DemoSensor demo(SensorModel::HlG203);
        QTcpSocket client;
        if (round % 4 == 0)
            continue; // never started
        QSignalSpy ready(&demo, &DemoSensor::ready);
        demo.start();
        if (round % 4 == 1)
            continue; // starting
        QVERIFY(ready.wait());
        client.connectToHost(QHostAddress::LocalHost, demo.port());
        QVERIFY(client.waitForConnected());
        if (round % 4 == 2)
            client.write(QByteArray::fromHex("0001 0000 0006 01 03 0064 0002"));
        demo.post([](SensorStation& station) { station.sensor().catchUp(); });
    }
}

QTEST_GUILESS_MAIN(DemoSensorTest)
#include "tst_demo_sensor.moc"
