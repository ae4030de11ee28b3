#include "demo_sensor.h"

#include "system_clock.h"

namespace lds::emulator {

namespace {
constexpr int tellEveryMs = 50;
}

/// Everything the thread owns. Deleted there, after the event loop has ended.
struct DemoSensor::Inside : QObject {
    SystemClock clock;
    std::unique_ptr<SensorStation> station;
    bool willTell = false; ///< A change is on its way out.
};

DemoSensor::DemoSensor(catalog::SensorModel model, QObject* parent)
    : QObject(parent)
{
    m_options.model = model;
    m_options.modbusPort = 0;
    m_thread.setObjectName(QStringLiteral("virtual sensor"));
}

DemoSensor::~DemoSensor()
{
    m_thread.quit();
    m_thread.wait();
}

void DemoSensor::start()
{
    if (m_inside)
        return;
    m_inside = new Inside;
    m_inside->clock.setParent(nullptr);
    m_inside->moveToThread(&m_thread);
    m_inside->clock.moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_inside, &QObject::deleteLater);
    m_thread.start();
    QMetaObject::invokeMethod(m_inside, [this, inside = m_inside, options = m_options] {
        auto station = SensorStation::start(options, inside->clock);
        if (!station) {
            QMetaObject::invokeMethod(this,
                                      [this, reason = station.error().message] { Q_EMIT failed(reason); });
            return;
        }
        inside->station = std::move(*station);
        QMetaObject::invokeMethod(this, [this, port = inside->station->modbusPort().value_or(0)] {
            m_port = port;
            Q_EMIT ready(port);
        });
        watch(inside);
    });
}

/// In the sensor's thread. A scene may change something every millisecond; screens are told less often.
void DemoSensor::watch(Inside* inside)
{
    const auto tell = [this, inside] {
        inside->willTell = false;
        QMetaObject::invokeMethod(this, [this, state = inside->station->state()] { take(state); });
    };
    connect(inside->station.get(), &SensorStation::stateChanged, inside, [inside, tell] {
        if (std::exchange(inside->willTell, true))
            return;
        inside->clock.after(tellEveryMs, inside, tell);
    });
    tell();
}

void DemoSensor::loadScene(const QString& pathOrExample)
{
    post([this, pathOrExample](SensorStation& station) {
        const auto loaded = station.loadScene(pathOrExample);
        if (loaded)
            return;
        QMetaObject::invokeMethod(this, [this, state = station.state(), reason = loaded.error()] {
            take(state); // what was chosen is not so
            Q_EMIT sceneRefused(reason);
        });
    });
}

void DemoSensor::take(const StationState& state)
{
    m_state = state;
    Q_EMIT stateChanged(m_state);
}

void DemoSensor::post(std::function<void(SensorStation&)> work)
{
    if (!m_inside)
        return;
    QMetaObject::invokeMethod(m_inside, [inside = m_inside, run = std::move(work)] {
        if (inside->station)
            run(*inside->station);
    });
}

void DemoSensor::runAndWait(const std::function<void(SensorStation&)>& work)
{
    Q_ASSERT(m_inside);
    QMetaObject::invokeMethod(
        m_inside,
        [inside = m_inside, &work] {
            if (inside->station)
                work(*inside->station);
        },
        Qt::BlockingQueuedConnection);
}

} // namespace lds::emulator
